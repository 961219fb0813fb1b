#include "tools/report/scale_bar.h"

#include <cmath>

#include "tools/report/html_text.h"

namespace enfilade::tools {

double round_length(double longest) {
    const double power = std::pow(10, std::floor(std::log10(longest)));
    return longest >= 5 * power ? 5 * power : longest >= 2 * power ? 2 * power : power;
}

std::string length_text(double metres) {
    return metres < 1 ? decimal(100 * metres, 0) + " cm" : decimal(metres, 0) + " m";
}

}  // namespace enfilade::tools
