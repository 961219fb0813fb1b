#pragma once
// Files of a test's own.

#include <map>
#include <string>

#include "modeler/catalogue/file_tree.h"
#include "tests/plans/home_file.h"

namespace enfilade::modeler::test {

class MemoryFiles final : public FileTree {
public:
    MemoryFiles(std::initializer_list<std::pair<const std::string, std::string>> files) : files_(files) {
        for (const auto& [name, bytes] : files_) names_.push_back(name);
    }
    [[nodiscard]] std::optional<std::string> read(const std::string& name) const override {
        const auto found = files_.find(name);
        return found == files_.end() ? std::nullopt : std::optional(found->second);
    }
    [[nodiscard]] const std::vector<std::string>& names() const override { return names_; }
    [[nodiscard]] const std::string& title() const override { return title_; }

private:
    std::map<std::string, std::string> files_;
    std::vector<std::string> names_;
    std::string title_ = "memory";
};

/// A zip archive of these entries, in their order.
using enfilade::testing::archive;

}  // namespace enfilade::modeler::test
