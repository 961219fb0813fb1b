#include <charconv>
#include <cmath>
#include <set>

#include "base/error.h"
#include "modeler/catalogue/properties.h"
#include "modeler/catalogue/source_index.h"

namespace enfilade::modeler {
namespace {

using Properties = std::map<std::string, std::string, std::less<>>;

constexpr double metres = 0.01;        ///< libraries write centimetres
constexpr double largest = 1e5;        ///< centimetres
constexpr std::size_t most = 100'000;  ///< entries

class Item {
public:
    Item(const Properties& properties, std::string number) : properties_(properties), suffix_("#" + number) {}

    [[nodiscard]] std::string text(const char* key) const {
        const auto found = properties_.find(key + suffix_);
        return found == properties_.end() ? std::string() : found->second;
    }
    [[nodiscard]] bool flag(const char* key) const { return text(key) == "true"; }
    [[nodiscard]] bool has(const char* key) const { return properties_.contains(key + suffix_); }
    [[nodiscard]] std::optional<double> number(const char* key) const {
        const std::string value = text(key);
        return number_in(value);
    }
    static std::optional<double> number_in(std::string_view text) {
        while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
        while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
        if (text.starts_with('+')) text.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= largest))
            return std::nullopt;
        return value;
    }
    /// Nine numbers, rows of a rotation; nothing where it is none.
    [[nodiscard]] std::optional<Rotation> rotation() const {
        const std::string value = text("modelRotation");
        Rotation rows{};
        std::size_t at = 0;
        for (double& x : rows) {
            at = value.find_first_not_of(' ', at);
            if (at == std::string::npos) return std::nullopt;
            const std::size_t end = std::min(value.find(' ', at), value.size());
            const auto read = number_in(std::string_view(value).substr(at, end - at));
            if (!read) return std::nullopt;
            x = *read;
            at = end;
        }
        return rows;
    }

private:
    const Properties& properties_;
    std::string suffix_;
};

/// The numbers behind # of all entries, ascending.
std::vector<std::string> item_numbers(const Properties& properties) {
    std::set<std::pair<std::size_t, std::string>> numbers;
    for (const auto& [key, value] : properties) {
        if (!key.starts_with("model#") && !key.starts_with("name#")) continue;
        std::string number = key.substr(key.find('#') + 1);
        const bool is_number = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
        if (is_number && numbers.size() < most) numbers.emplace(number.size(), std::move(number));
    }
    std::vector<std::string> out;
    for (const auto& entry : numbers) out.push_back(entry.second);
    return out;
}

CatalogueRecord record_of(const Item& item, const std::string& number, const std::string& title,
                          const std::string& licence) {
    CatalogueRecord record;
    CatalogueEntry& entry = record.entry;
    entry.id = item.text("id");
    if (entry.id.empty()) entry.id = stem_of_name(title) + "#" + number;
    entry.name = item.text("name");
    if (entry.name.empty()) entry.name = entry.id;
    entry.category = item.text("category");
    entry.creator = item.text("creator");
    entry.licence = item.has("license") ? item.text("license") : licence;
    entry.elevation = std::max(0.0, item.number("elevation").value_or(0) * metres);
    record.model = item.text("model");
    record.cleared = !item.has("staircaseCutOutShape");
    if (const auto rotation = item.rotation()) record.fitting.rotation = *rotation;
    record.fitting.unit = metres;
    const auto width = item.number("width");
    const auto depth = item.number("depth");
    const auto height = item.number("height");
    if (width && depth && height && *width > 0 && *depth > 0 && *height > 0)
        record.fitting.size = {*width * metres, *depth * metres, *height * metres};
    if (const auto top = item.number("dropOnTopElevation"); top && *top > 0) entry.top = *top * metres;
    return record;
}

}  // namespace

void list_library(const FileTree& files, const std::string& title, SourceIndex& index) {
    const auto text = files.read("PluginFurnitureCatalog.properties");
    if (!text)
        throw InputError("K104", title,
                         "The archive holds no PluginFurnitureCatalog.properties, so it is no furniture library of "
                         "Sweet Home 3D.");
    const Properties properties = read_properties(*text);
    const auto licence = properties.find("license");
    std::size_t openings = 0;
    std::size_t without_model = 0;
    for (const std::string& number : item_numbers(properties)) {
        const Item item(properties, number);
        if (item.flag("doorOrWindow")) {
            ++openings;
            continue;
        }
        if (item.text("model").empty()) {
            ++without_model;
            continue;
        }
        index.records.push_back(
            record_of(item, number, title, licence == properties.end() ? std::string() : licence->second));
    }
    if (openings > 0)
        index.findings.push_back(source_finding(
            "K151", Severity::Note, title + ": " + std::to_string(openings) + " doors and windows are left out.",
            "They belong to walls; a plan brings its own."));
    if (without_model > 0)
        index.findings.push_back(
            source_finding("K150", Severity::Warning,
                           title + ": " + std::to_string(without_model) + " entries name no model and are left out.",
                           "Edit the library with Sweet Home 3D's Furniture Library Editor."));
}

}  // namespace enfilade::modeler
