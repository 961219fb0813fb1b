#include <algorithm>

#include "base/error.h"
#include "modeler/catalogue/read_model.h"
#include "modeler/catalogue/sidecar.h"
#include "modeler/catalogue/source_index.h"

namespace enfilade::modeler {
namespace {

constexpr const char* sidecar_name = "catalogue.json";

/// OBJ and glTF are written with y up, the formats of scanners and printers with z up.
UpAxis usual_up(const std::string& mesh) {
    const std::string extension = extension_of_name(mesh);
    return extension == "ply" || extension == "off" || extension == "stl" ? UpAxis::Z : UpAxis::Y;
}

/// "L_shaped-sofa" -> "L shaped sofa".
std::string name_for_people(const std::string& mesh) {
    std::string name = stem_of_name(mesh);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
    return name;
}

CatalogueRecord record_of(const std::string& mesh, const std::string& folder, const SidecarEntry& words,
                          const std::string& sidecar_title) {
    CatalogueRecord record;
    record.model = mesh;
    record.entry.id = folder.empty() ? mesh : folder + "/" + mesh;
    record.entry.name = words.name.value_or(name_for_people(mesh));
    record.entry.category = words.category.value_or("");
    record.entry.creator = words.creator.value_or("");
    record.entry.licence = words.licence.value_or("");
    record.entry.elevation = words.elevation.value_or(0);
    record.entry.top = words.top;
    record.entry.kind = words.kind.value_or("");
    record.cleared = !words.kind;
    record.bare = !words.size && !words.unit;
    record.fitting.up = words.up;
    record.fitting.unit = words.unit.value_or(1);
    record.fitting.size = words.size;
    if (words.front) {
        const auto front = front_along(*words.front, words.up.value_or(usual_up(mesh)));
        if (!front)
            throw InputError("K105", sidecar_title,
                             "The front \"" + *words.front + "\" of " + mesh +
                                 " is its top or bottom: name an axis that lies flat.");
        record.fitting.front = *front;
    }
    return record;
}

}  // namespace

void list_meshes(const FileTree& files, const std::filesystem::path& path, SourceIndex& index) {
    const bool is_folder = index.kind == SourceKind::Folder;
    const std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
    const std::filesystem::path folder =
        is_folder ? (whole.has_filename() ? whole : whole.parent_path()) : whole.parent_path();
    const std::string sidecar_title = (folder / sidecar_name).string();
    Sidecar sidecar;
    if (const auto text = files.read(sidecar_name)) sidecar = read_sidecar(*text, sidecar_title);
    std::size_t absent = 0;
    for (const std::string& name : files.names())
        if (has_model_extension(name))
            index.records.push_back(
                record_of(name, folder.filename().string(), words_for(sidecar, name), sidecar_title));
    for (const auto& [name, words] : sidecar.meshes)
        if (is_folder && !std::binary_search(files.names().begin(), files.names().end(), name)) ++absent;
    if (absent > 0)
        index.findings.push_back(source_finding(
            "K157", Severity::Warning,
            sidecar_title + " tells of " + std::to_string(absent) + " meshes that are not in the folder.",
            "Compare its names with those of the files."));
}

}  // namespace enfilade::modeler
