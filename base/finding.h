#pragma once
// What a stage has to say about a plan or a model: repairs, warnings, defects.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace enfilade {

enum class Severity { Note, Warning, Error };

/// One element of the plan that a finding is about.
struct ElementRef {
    std::string kind;  ///< "wall", "room", "opening", "stair", "storey", ...
    std::string id;
    std::string name;  ///< empty where the plan gives none
};

/// One sentence for a person, with its code, its place and what to do about it.
struct Finding {
    std::string code;  ///< P... from the readers and the plan stage, T/G/S/D... from `modeler::check` (docs/checks.md)
    Severity severity = Severity::Warning;
    std::string sentence;
    std::string hint;
    std::optional<std::array<double, 3>> point;  ///< metres, in the frame of the plan file's model
    std::string storey;                          ///< id of the storey, empty where it has none
    std::vector<ElementRef> elements;
    double moved_mm = 0;  ///< how far a repair moved something, 0 where nothing moved
};

[[nodiscard]] inline bool has_errors(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings)
        if (finding.severity == Severity::Error) return true;
    return false;
}

[[nodiscard]] inline const char* name_of(Severity severity) {
    switch (severity) {
        case Severity::Note: return "note";
        case Severity::Warning: return "warning";
        case Severity::Error: return "error";
    }
    return "error";
}

}  // namespace enfilade
