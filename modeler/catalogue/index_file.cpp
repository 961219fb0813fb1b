#include <nlohmann/json.hpp>

#include "modeler/catalogue/cache.h"

namespace enfilade::modeler {
namespace {

using nlohmann::json;

json json_of(const CatalogueRecord& record) {
    const CatalogueEntry& entry = record.entry;
    const MeshDefects& defects = entry.defects;
    const Fitting& fitting = record.fitting;
    json out = {{"id", entry.id},
                {"name", entry.name},
                {"kind", entry.kind},
                {"category", entry.category},
                {"size", {entry.width, entry.depth, entry.height}},
                {"elevation", entry.elevation},
                {"triangles", entry.triangles},
                {"defects",
                 {{"degenerate", defects.degenerate},
                  {"duplicate", defects.duplicate},
                  {"open_edges", defects.open_edges},
                  {"crowded_edges", defects.crowded_edges},
                  {"dropped", defects.dropped}}},
                {"source", entry.source},
                {"creator", entry.creator},
                {"licence", entry.licence},
                {"model", record.model},
                {"unit", fitting.unit},
                {"front", static_cast<int>(fitting.front)}};
    if (entry.top) out["top"] = *entry.top;
    if (!record.alias.empty()) out["alias"] = record.alias;
    if (fitting.rotation != no_rotation) out["rotation"] = fitting.rotation;
    if (fitting.up) out["up"] = static_cast<int>(*fitting.up);
    if (fitting.size) out["stated_size"] = *fitting.size;
    return out;
}

CatalogueRecord record_of(const json& from) {
    CatalogueRecord record;
    CatalogueEntry& entry = record.entry;
    entry.id = from.at("id");
    entry.name = from.at("name");
    entry.kind = from.at("kind");
    entry.category = from.at("category");
    entry.width = from.at("size").at(0);
    entry.depth = from.at("size").at(1);
    entry.height = from.at("size").at(2);
    entry.elevation = from.at("elevation");
    if (from.contains("top")) entry.top = from["top"].get<double>();
    entry.triangles = from.at("triangles");
    const json& defects = from.at("defects");
    entry.defects = {defects.at("degenerate"), defects.at("duplicate"), defects.at("open_edges"),
                     defects.at("crowded_edges"), defects.at("dropped")};
    entry.source = from.at("source");
    entry.creator = from.at("creator");
    entry.licence = from.at("licence");
    record.model = from.at("model");
    record.alias = from.value("alias", "");
    Fitting& fitting = record.fitting;
    fitting.unit = from.at("unit");
    fitting.front = static_cast<Front>(from.at("front").get<int>());
    if (from.contains("rotation")) fitting.rotation = from["rotation"].get<Rotation>();
    if (from.contains("up")) fitting.up = static_cast<UpAxis>(from["up"].get<int>());
    if (from.contains("stated_size")) fitting.size = from["stated_size"].get<std::array<double, 3>>();
    return record;
}

}  // namespace

std::string index_text(const CacheKey& key, const SourceIndex& index) {
    json out = {{"place", key.place}, {"state", key.state}, {"kind", static_cast<int>(index.kind)}};
    out["findings"] = json::array();
    for (const Finding& finding : index.findings)
        out["findings"].push_back({{"code", finding.code},
                                   {"severity", static_cast<int>(finding.severity)},
                                   {"sentence", finding.sentence},
                                   {"hint", finding.hint}});
    out["entries"] = json::array();
    for (const CatalogueRecord& record : index.records) out["entries"].push_back(json_of(record));
    return out.dump(1, '\t', false, json::error_handler_t::replace) + "\n";
}

std::optional<SourceIndex> read_index(std::string_view text, const CacheKey& key) {
    const json from = json::parse(text);
    const auto clean = [](const std::string& raw) {  // as it was written: what is no UTF-8 replaced
        return json::parse(json(raw).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
    };
    if (from.at("place") != clean(key.place) || from.at("state") != clean(key.state)) return std::nullopt;
    SourceIndex index;
    index.kind = static_cast<SourceKind>(from.at("kind").get<int>());
    for (const json& item : from.at("findings")) {
        Finding finding{.code = item.at("code"), .severity = static_cast<Severity>(item.at("severity").get<int>())};
        finding.sentence = item.at("sentence");
        finding.hint = item.at("hint");
        index.findings.push_back(std::move(finding));
    }
    for (const json& item : from.at("entries")) index.records.push_back(record_of(item));
    return index;
}

}  // namespace enfilade::modeler
