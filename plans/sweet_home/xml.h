#pragma once
// Home.xml as a tree of elements whose attributes are read with care.

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "plans/plan.h"

namespace enfilade::plans {

/// Parses the text. Throws InputError with line and column: P154 not well-formed, P155 no home, P156 nested too deeply.
/// Stricter than pugixml, which lets a bare `&` pass: what Sweet Home 3D would refuse is refused here too.
void parse_home_xml(pugi::xml_document& document, std::string_view text, const std::string& file_name);

/// What an attribute may hold, in its own unit.
struct NumberRange {
    double min = -1e300;
    double max = 1e300;
    bool open_min = false;
    [[nodiscard]] bool holds(double value) const { return (open_min ? value > min : value >= min) && value <= max; }
};

/// One element of Home.xml. What it cannot use of its optional attributes it says in the findings, by its own kind
/// and name, and goes on with the default.
class HomeElement {
public:
    HomeElement(pugi::xml_node node, std::vector<Finding>& findings) : node_(node), findings_(&findings) {}

    [[nodiscard]] pugi::xml_node node() const { return node_; }
    [[nodiscard]] HomeElement child(pugi::xml_node node) const { return {node, *findings_}; }
    [[nodiscard]] bool has(const char* key) const { return static_cast<bool>(node_.attribute(key)); }
    /// As UTF-8; empty where the attribute is absent.
    [[nodiscard]] std::string text(const char* key) const;
    [[nodiscard]] bool flag(const char* key, bool fallback) const;

    /// Nothing where the attribute is absent, no finite number, or out of range.
    [[nodiscard]] std::optional<double> number(const char* key, const NumberRange& range) const;
    /// The fallback where it is absent, and with a warning where it is unusable.
    [[nodiscard]] double number(const char* key, const NumberRange& range, double fallback) const;
    /// Lengths of the file in metres; range and fallback are metres.
    [[nodiscard]] std::optional<double> metres(const char* key, const NumberRange& range) const;
    [[nodiscard]] double metres(const char* key, const NumberRange& range, double fallback) const;
    /// ARGB in hexadecimal as Sweet Home 3D writes it, or in decimal as some scripts do.
    [[nodiscard]] std::optional<Colour> colour(const char* key) const;
    /// The child `texture` of that attribute whose picture the file holds; one without a usable size is told and left
    /// out.
    [[nodiscard]] std::optional<SurfaceTexture> texture(const char* attribute) const;

    /// Says that the attribute's value cannot be used, and what is taken instead.
    void unusable(const char* key, const std::string& instead) const { report_unusable(key, instead); }

    /// "wall \"wall-1\"" or "door \"Front door\" (doorOrWindow-3)": how a sentence names it.
    [[nodiscard]] std::string label() const;

private:
    void report_unusable(const char* key, const std::string& instead) const;

    pugi::xml_node node_;
    std::vector<Finding>* findings_;
};

}  // namespace enfilade::plans
