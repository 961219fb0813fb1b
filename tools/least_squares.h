#pragma once
// Fitting a few non-negative constants to many measurements.

#include <span>
#include <vector>

namespace enfilade::tools {

/// One measurement: y = sum of constants[i] * x[i], known to a standard deviation proportional to `deviation`.
struct Measurement {
    std::vector<double> x;
    double y = 0;
    double deviation = 1;
};

struct Fit {
    std::vector<double> constants;        ///< none negative: where the best one would be, it is 0
    std::vector<double> standard_errors;  ///< 0 for constants held at 0
    double median_residual = 0;           ///< of |y - fit| / y
};

/// Weighted least squares. All measurements have as many `x`. \pre more measurements than constants
[[nodiscard]] Fit fit_constants(std::span<const Measurement> measurements);

/// Pearson's coefficient. 0 where one of them does not vary.
[[nodiscard]] double correlation(std::span<const double> a, std::span<const double> b);

}  // namespace enfilade::tools
