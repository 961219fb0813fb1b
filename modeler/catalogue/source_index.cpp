#include "modeler/catalogue/source_index.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "base/error.h"
#include "modeler/catalogue/kind_words.h"
#include "modeler/catalogue/read_model.h"
#include "plans/number_text.h"
#include "plans/utf8.h"

namespace enfilade::modeler {
namespace {

constexpr std::size_t models_a_chunk = 8;  ///< an archive is opened anew for each chunk
constexpr std::size_t most_refusals_told = 10;

/// What reading a model found, beside its record.
struct ModelVerdict {
    std::string refused;
    double unit_guessed = 0;
    bool odd_size = false;
    bool lacks_materials = false;
    bool unseen = false;  ///< of a home: there is nothing to see, and that may be meant
};

std::string size_text(const CatalogueEntry& entry) {
    return plans::rounded_text(entry.width, 3) + " x " + plans::rounded_text(entry.depth, 3) + " x " +
           plans::rounded_text(entry.height, 3) + " m";
}

/// Meshes say nothing of their unit. What is more than 20 m large in metres is taken as centimetres, more than that in
/// centimetres as millimetres.
double guessed_unit(const std::array<double, 3>& size) {
    constexpr double largest_piece = 20;
    const double largest = std::max({size[0], size[1], size[2]});
    for (const double unit : {1.0, 0.01, 0.001})
        if (largest * unit <= largest_piece) return unit;
    return 0.001;
}

/// Sides of 0 follow the scale of the first that is given.
void complete_size(Fitting& fitting, const std::array<double, 3>& natural) {
    double scale = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (scale == 0 && (*fitting.size)[k] > 0 && natural[k] > 0) scale = (*fitting.size)[k] / natural[k];
    for (std::size_t k = 0; k < 3; ++k)
        if ((*fitting.size)[k] == 0) (*fitting.size)[k] = natural[k] * scale;
}

void tell_kind(CatalogueRecord& record) {
    CatalogueEntry& entry = record.entry;
    if (record.cleared)
        entry.kind = kind_of_piece(
            {entry.name, entry.id, entry.category, entry.width, entry.depth, entry.height, entry.elevation});
    if (!entry.top && has_flat_top(entry.kind)) entry.top = entry.height;
    if (entry.top && !(*entry.top > 0 && *entry.top <= entry.height * (1 + 1e-9))) entry.top.reset();
}

ModelVerdict examine(const FileTree& files, CatalogueRecord& record, bool may_be_unseen) {
    ModelVerdict verdict;
    CatalogueEntry& entry = record.entry;
    try {
        const RawMesh raw = read_model(files, record.model, ReadImages::No);
        const std::array<double, 3> natural = natural_size(raw, record.fitting);
        if (record.bare && !raw.in_metres) {
            record.fitting.unit = guessed_unit(natural);
            if (record.fitting.unit != 1) verdict.unit_guessed = record.fitting.unit;
        }
        if (record.fitting.size) complete_size(record.fitting, natural);
        const ObjectMesh mesh = fitted(raw, record.fitting, entry.name);
        if (mesh.triangles.empty())
            throw InputError("K109", files.title(),
                             "The model " + record.model + " cannot be used: all of it is invisible.");
        const MeshBox box = box_of(mesh);
        entry.width = box.side(0);
        entry.depth = box.side(1);
        entry.height = box.side(2);
        entry.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
        entry.defects = defects_of(mesh);
        entry.defects.dropped = raw.dropped;
        const double largest = std::max({entry.width, entry.depth, entry.height});
        verdict.odd_size = record.bare && !(largest >= 0.005 && largest <= 20);
        verdict.lacks_materials = raw.lacks_materials;
        tell_kind(record);
    } catch (const InputError& error) {
        // Sources of light have models without a face, and people make stairs invisible.
        verdict.unseen = may_be_unseen && error.code == "K109";
        if (!verdict.unseen) verdict.refused = error.what();
    }
    return verdict;
}

void report_refusals(const std::string& title, const std::vector<CatalogueRecord>& records,
                     const std::vector<ModelVerdict>& verdicts, SourceIndex& index) {
    std::size_t refused = 0;
    for (std::size_t k = 0; k < records.size(); ++k) {
        if (verdicts[k].refused.empty() || ++refused > most_refusals_told) continue;
        index.findings.push_back(source_finding("K150", Severity::Warning, title + ": " + verdicts[k].refused,
                                                "It is left out; pieces that use it stand as boxes."));
    }
    if (refused > most_refusals_told)
        index.findings.push_back(
            source_finding("K150", Severity::Warning,
                           title + ": " + std::to_string(refused - most_refusals_told) + " more models cannot be used.",
                           "They are left out; pieces that use them stand as boxes."));
}

void report_sizes(const std::string& title, const std::vector<CatalogueRecord>& records,
                  const std::vector<ModelVerdict>& verdicts, SourceIndex& index) {
    for (std::size_t k = 0; k < records.size(); ++k) {
        const CatalogueEntry& entry = records[k].entry;
        if (verdicts[k].unit_guessed > 0)
            index.findings.push_back(
                source_finding("K153", Severity::Note,
                               title + ": " + records[k].model + " is taken as written in " +
                                   (verdicts[k].unit_guessed == 0.01 ? "centimetres" : "millimetres") +
                                   ", which makes it " + size_text(entry) + ".",
                               "Where that is wrong, say its \"unit\" or \"size\" in catalogue.json beside it."));
        if (verdicts[k].odd_size)
            index.findings.push_back(source_finding(
                "K158", Severity::Warning,
                title + ": " + records[k].model + " would be " + size_text(entry) + ", a size that no furniture has.",
                "Say its \"unit\" or \"size\" in catalogue.json beside it."));
    }
}

/// One finding for all models with a defect of a kind: libraries have hundreds.
void report_defects(const std::string& title, const std::vector<CatalogueRecord>& records,
                    const std::vector<ModelVerdict>& verdicts, SourceIndex& index) {
    std::size_t dropped = 0, dropping = 0, flat = 0, twice = 0, crowded = 0, colourless = 0, without_size = 0,
                unseen = 0;
    for (std::size_t k = 0; k < records.size(); ++k) {
        if (!verdicts[k].refused.empty()) continue;
        const MeshDefects& defects = records[k].entry.defects;
        dropped += defects.dropped;
        dropping += defects.dropped > 0;
        flat += defects.degenerate > 0;
        twice += defects.duplicate > 0;
        crowded += defects.crowded_edges > 0;
        colourless += verdicts[k].lacks_materials;
        unseen += verdicts[k].unseen;
        without_size += index.kind == SourceKind::Library && !records[k].fitting.size;
    }
    // "12 models have", "1 model has"
    const auto say = [&](std::size_t count, const char* code, Severity severity, const char* verb,
                         const std::string& rest, const char* hint) {
        if (count == 0) return;
        const std::string subject = std::to_string(count) + (count == 1 ? " model " : " models ");
        const std::string form = std::string(verb) == "have" && count == 1 ? "has"
                                 : count == 1                              ? std::string(verb) + "s"
                                                                           : verb;
        index.findings.push_back(source_finding(code, severity, title + ": " + subject + form + " " + rest, hint));
    };
    say(dropping, "K154", Severity::Warning, "lose",
        std::to_string(dropped) + " triangles in all, whose corners do not exist, are no numbers or lie beyond 1e12.",
        "The rest is used; export them again.");
    say(flat, "K155", Severity::Note, "have", "triangles without area; they are kept.", "");
    say(twice, "K155", Severity::Note, "have", "triangles that are there twice; they are kept.", "");
    say(crowded, "K155", Severity::Note, "have", "edges of three triangles or more; they are kept.", "");
    say(colourless, "K156", Severity::Note, "name",
        "materials that no file describes; a colour is taken by the name, or grey.", "");
    say(unseen, "K159", Severity::Note, "have", "nothing that can be seen; so have the pieces that use them.", "");
    say(without_size, "K152", Severity::Warning, "have",
        "no width, depth and height; the size of the file is taken, in centimetres.",
        "Add their sizes with Sweet Home 3D's Furniture Library Editor.");
}

/// By id, each id once: what comes again is numbered.
void put_in_order(SourceIndex& index) {
    std::set<std::string, std::less<>> taken;
    for (CatalogueRecord& record : index.records) {
        std::string id = plans::to_utf8(record.entry.id);
        for (int k = 2; !taken.insert(id).second; ++k) id = plans::to_utf8(record.entry.id) + "#" + std::to_string(k);
        record.entry.id = id;
    }
    std::sort(index.records.begin(), index.records.end(),
              [](const CatalogueRecord& a, const CatalogueRecord& b) { return a.entry.id < b.entry.id; });
}

std::string first_bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw InputError("K101", file.string(), "The file cannot be opened; check its name and its permissions.");
    std::string bytes(4, '\0');
    stream.read(bytes.data(), 4);
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

}  // namespace

bool has_flat_top(std::string_view kind) {
    static constexpr std::string_view kinds[] = {
        "bedside_table", "chest_of_drawers", "coffee_table",   "tv_stand",     "dining_table",    "round_table",
        "sideboard",     "meeting_table",    "filing_cabinet", "kitchen_unit", "washing_machine", "shoe_cabinet"};
    return std::find(std::begin(kinds), std::end(kinds), kind) != std::end(kinds);
}

Finding source_finding(const char* code, Severity severity, std::string sentence, std::string hint) {
    Finding finding{.code = code, .severity = severity};
    finding.sentence = plans::to_utf8(sentence);
    finding.hint = std::move(hint);
    return finding;
}

SourceKind source_kind(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        throw InputError("K101", path.string(), "There is no such file or folder; check its name.");
    if (std::filesystem::is_directory(status)) return SourceKind::Folder;
    const bool is_zip = first_bytes(path).starts_with("PK");
    const std::string extension = extension_of_name(path.string());
    if (extension == "sh3f") return SourceKind::Library;
    if (extension == "sh3d") return SourceKind::Home;
    if (is_zip) {
        const auto files = open_archive(path);
        if (files->read("PluginFurnitureCatalog.properties")) return SourceKind::Library;
        if (files->read("Home.xml")) return SourceKind::Home;
    } else if (has_model_extension(path.string())) {
        return SourceKind::File;
    }
    throw InputError("K102", path.string(),
                     "This is no catalogue: libraries (.sh3f) and homes (.sh3d) of Sweet Home 3D, folders, and meshes "
                     "(.obj, .gltf, .glb, .ply, .off, .stl) are.");
}

std::unique_ptr<FileTree> open_source(const std::filesystem::path& path, SourceKind kind) {
    switch (kind) {
        case SourceKind::Folder: return open_folder(path);
        case SourceKind::File: return open_file(path);
        default: return open_archive(path);
    }
}

SourceIndex read_source(const std::filesystem::path& path, const accel::Executor& executor) {
    SourceIndex index;
    index.kind = source_kind(path);
    const std::string title = path.string();
    const auto files = open_source(path, index.kind);
    switch (index.kind) {
        case SourceKind::Library: list_library(*files, title, index); break;
        case SourceKind::Home: list_home(*files, title, index); break;
        default: list_meshes(*files, path, index);
    }
    for (CatalogueRecord& record : index.records) record.entry.source = plans::to_utf8(title);
    put_in_order(index);
    std::vector<CatalogueRecord>& records = index.records;
    std::vector<ModelVerdict> verdicts(records.size());
    accel::parallel_for(executor, records.size(), models_a_chunk, [&](std::size_t begin, std::size_t end) {
        const auto own = open_source(path, index.kind);  // libzip reads one entry at a time
        for (std::size_t k = begin; k < end; ++k)
            verdicts[k] = examine(*own, records[k], index.kind == SourceKind::Home);
    });
    report_refusals(title, records, verdicts, index);
    report_sizes(title, records, verdicts, index);
    report_defects(title, records, verdicts, index);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < records.size(); ++k)
        if (verdicts[k].refused.empty()) {
            if (kept != k) records[kept] = std::move(records[k]);
            ++kept;
        }
    records.resize(kept);
    return index;
}

}  // namespace enfilade::modeler
