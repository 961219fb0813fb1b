#include "modeler/catalogue/sidecar.h"

#include "plans/json_fields.h"

namespace enfilade::modeler {
namespace {

using plans::Fields;
using plans::JsonValue;

constexpr std::string_view file_words[] = {"defaults", "meshes"};
constexpr std::string_view entry_words[] = {"name",  "kind",      "category", "size",    "unit",   "up",
                                            "front", "elevation", "top",      "creator", "licence"};
constexpr plans::JsonKeys file_keys{"catalogue", file_words};
constexpr plans::JsonKeys entry_keys{"mesh", entry_words};
constexpr plans::Range extent{0, 1e4};

std::optional<std::string> optional_text(const Fields& fields, const char* key) {
    return fields.has(key) ? std::optional(fields.text(key)) : std::nullopt;
}

std::optional<double> optional_number(const Fields& fields, const char* key, plans::Range range) {
    return fields.has(key) ? std::optional(fields.number(key, range)) : std::nullopt;
}

[[noreturn]] void refuse(const plans::JsonSource& source, const JsonValue& at, const std::string& sentence) {
    plans::refuse(source, "P105", at.place, sentence);
}

std::array<double, 3> read_size(const JsonValue& value, const plans::JsonSource& source) {
    const JsonValue::Array* list = value.array();
    std::array<double, 3> size{};
    bool is_size = list != nullptr && list->size() == 3;
    for (std::size_t k = 0; is_size && k < 3; ++k) {
        const double* number = (*list)[k].number();
        is_size = number != nullptr && *number >= extent.low && *number <= extent.high;
        if (is_size) size[k] = *number;
    }
    if (!is_size || size == std::array<double, 3>{})
        refuse(source, value, "\"size\" is [width, depth, height] in metres, 0 for a side that follows the others.");
    return size;
}

SidecarEntry read_entry(const JsonValue& value, const plans::JsonSource& source) {
    const Fields fields(value, entry_keys, source);
    SidecarEntry entry;
    entry.name = optional_text(fields, "name");
    entry.kind = optional_text(fields, "kind");
    entry.category = optional_text(fields, "category");
    entry.creator = optional_text(fields, "creator");
    entry.licence = optional_text(fields, "licence");
    entry.unit = optional_number(fields, "unit", {0, 1e4, true});
    entry.elevation = optional_number(fields, "elevation", extent);
    entry.top = optional_number(fields, "top", extent);
    entry.front = optional_text(fields, "front");
    if (const JsonValue* size = fields.find("size")) entry.size = read_size(*size, source);
    if (const auto up = optional_text(fields, "up")) {
        if (*up != "y" && *up != "z") refuse(source, fields.at("up"), "\"up\" is \"y\" or \"z\".");
        entry.up = *up == "y" ? UpAxis::Y : UpAxis::Z;
    }
    const bool is_axis =
        !entry.front || (entry.front->size() == 2 && (entry.front->front() == '+' || entry.front->front() == '-') &&
                         entry.front->back() >= 'x' && entry.front->back() <= 'z');
    if (!is_axis) refuse(source, fields.at("front"), "\"front\" is an axis of the file: \"+x\", \"-x\", \"+y\" ...");
    return entry;
}

template <class Value>
void prefer(std::optional<Value>& own, const std::optional<Value>& fallback) {
    if (!own) own = fallback;
}

}  // namespace

Sidecar read_sidecar(std::string_view text, const std::string& file) {
    const plans::JsonSource source{file, 1};
    const JsonValue root = plans::parse_json(text, file);
    const Fields fields(root, file_keys, source);
    Sidecar sidecar;
    if (const JsonValue* defaults = fields.find("defaults")) sidecar.defaults = read_entry(*defaults, source);
    if (const JsonValue* meshes = fields.find("meshes")) {
        const JsonValue::Object* members = meshes->object();
        if (members == nullptr)
            plans::refuse(source, "P103", meshes->place, "\"meshes\" is an object: each mesh by the name of its file.");
        for (const plans::JsonMember& member : *members)
            sidecar.meshes.emplace(member.key, read_entry(member.value, source));
    }
    return sidecar;
}

SidecarEntry words_for(const Sidecar& sidecar, std::string_view mesh) {
    const auto found = sidecar.meshes.find(mesh);
    SidecarEntry entry = found == sidecar.meshes.end() ? SidecarEntry{} : found->second;
    const SidecarEntry& all = sidecar.defaults;
    prefer(entry.name, all.name);
    prefer(entry.kind, all.kind);
    prefer(entry.category, all.category);
    prefer(entry.size, all.size);
    prefer(entry.unit, all.unit);
    prefer(entry.up, all.up);
    prefer(entry.front, all.front);
    prefer(entry.elevation, all.elevation);
    prefer(entry.top, all.top);
    prefer(entry.creator, all.creator);
    prefer(entry.licence, all.licence);
    return entry;
}

std::optional<Front> front_along(std::string_view axis, UpAxis up) {
    if (axis.size() != 2 || (axis[0] != '+' && axis[0] != '-')) return std::nullopt;
    const bool plus = axis[0] == '+';
    if (axis[1] == 'x') return plus ? Front::PlusX : Front::MinusX;
    if (up == UpAxis::Z && axis[1] == 'y') return plus ? Front::PlusY : Front::MinusY;
    if (up == UpAxis::Y && axis[1] == 'z') return plus ? Front::MinusY : Front::PlusY;  // (x, y, z) -> (x, -z, y)
    return std::nullopt;
}

}  // namespace enfilade::modeler
