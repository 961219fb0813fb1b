#pragma once
// Names of files, found as sloppily as they are written.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::modeler {

/// ASCII letters alone.
[[nodiscard]] std::string in_lower_case(std::string_view text);

class NameIndex {
public:
    NameIndex() = default;
    explicit NameIndex(const std::vector<std::string>& names);
    /// The place in `names` of this one: as written, or else with URL escapes read, or else in any case.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;

private:
    std::map<std::string, std::size_t, std::less<>> exact_;
    std::map<std::string, std::size_t, std::less<>> lower_;
};

}  // namespace enfilade::modeler
