#include "tools/convexifiers.h"

#include <vector>

#include "base/error.h"
#include "tools/suggestion.h"

namespace enfilade::tools {

const char* name_of(modeler::Convexifier convexifier) {
    for (const NamedConvexifier& named : named_convexifiers)
        if (named.convexifier == convexifier) return named.name;
    return "sah";
}

modeler::Convexifier convexifier_of(std::string_view name) {
    std::vector<std::string> known;
    std::string list;
    for (std::size_t i = 0; i < named_convexifiers.size(); ++i) {
        if (named_convexifiers[i].name == name) return named_convexifiers[i].convexifier;
        known.emplace_back(named_convexifiers[i].name);
        list += (i == 0 ? "" : i + 1 < named_convexifiers.size() ? ", " : " or ") + known.back();
    }
    throw InputError("F103", "",
                     "--convexify \"" + std::string(name) + "\" is no way to cut rooms into cells" +
                         suggestion(name, known) + ": choose " + list + '.');
}

}  // namespace enfilade::tools
