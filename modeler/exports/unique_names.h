#pragma once
// Names that must differ from each other in a file.

#include <set>
#include <string>

namespace enfilade::modeler {

/// Gives each name that is taken already a number of its own: "door", "door (2)", ...
class UniqueNames {
public:
    [[nodiscard]] std::string of(const std::string& wanted) {
        const std::string name = wanted.empty() ? "unnamed" : wanted;
        std::string candidate = name;
        for (int k = 2; !taken_.insert(candidate).second; ++k) candidate = name + " (" + std::to_string(k) + ")";
        return candidate;
    }

private:
    std::set<std::string> taken_;
};

}  // namespace enfilade::modeler
