#include "modeler/catalogue/catalogue.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "modeler/catalogue/cache.h"
#include "modeler/catalogue/decimate.h"
#include "modeler/catalogue/own_pieces.h"
#include "modeler/catalogue/read_model.h"
#include "modeler/catalogue/source_index.h"

namespace enfilade::modeler {
namespace {

/// A library, home or folder as it was when it was added.
struct Source {
    std::filesystem::path path;
    SourceKind kind = SourceKind::File;
    CacheKey key;
};

/// How the mesh of an entry is had: from a source, or made by ourselves.
struct Origin {
    std::size_t source = SIZE_MAX;
    CatalogueRecord record;  ///< its entry stands in State::entries
    const OwnPiece* own = nullptr;
};

void refuse_if_useless(const std::filesystem::path& path, const SourceIndex& index) {
    if (!index.records.empty() || index.kind == SourceKind::Home) return;  // a home may be empty
    std::string why = "It holds no mesh that can be used.";
    for (const Finding& finding : index.findings)
        if (finding.code == "K150") {
            why = index.kind == SourceKind::File ? finding.sentence : why + " " + finding.sentence;
            break;
        }
    throw InputError("K106", path.string(), why);
}

}  // namespace

struct Catalogue::State {
    CatalogueOptions options;
    Cache cache{{}};
    std::vector<Source> sources;
    std::vector<CatalogueEntry> entries;
    std::vector<Origin> origins;  ///< of each entry
    std::size_t own_count = 0;    ///< the last of them
    std::map<std::string, std::size_t, std::less<>> by_id;
    std::map<std::string, std::size_t, std::less<>> by_alias;
    std::vector<Finding> findings;

    void add_own() {
        for (const OwnPiece& piece : own_pieces()) {
            const ObjectMesh mesh = piece.make(options.detail);
            CatalogueEntry entry = piece.entry;
            entry.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
            entry.defects = defects_of(mesh);
            entries.push_back(std::move(entry));
            origins.push_back({.own = &piece});
        }
        own_count = entries.size();
        number();
    }

    /// What is found by which name: of equal ids and names the first counts.
    void number() {
        by_id.clear();
        by_alias.clear();
        for (std::size_t k = 0; k < entries.size(); ++k) {
            by_id.emplace(entries[k].id, k);
            if (!origins[k].record.alias.empty()) by_alias.emplace(origins[k].record.alias, k);
        }
    }

    /// Behind what was added before, ahead of our own. Ids that another source has already get its name in front.
    void insert(SourceIndex&& index, std::size_t source, const std::string& title) {
        std::vector<CatalogueEntry> added;
        std::vector<Origin> added_origins;
        for (CatalogueRecord& record : index.records) {
            CatalogueEntry entry = std::move(record.entry);
            if (by_id.contains(entry.id)) entry.id = title + "/" + entry.id;
            record.entry = {.id = entry.id, .name = entry.name, .triangles = entry.triangles};
            added.push_back(std::move(entry));
            added_origins.push_back({source, std::move(record), nullptr});
        }
        const auto at = static_cast<std::ptrdiff_t>(entries.size() - own_count);
        entries.insert(entries.begin() + at, std::make_move_iterator(added.begin()),
                       std::make_move_iterator(added.end()));
        origins.insert(origins.begin() + at, std::make_move_iterator(added_origins.begin()),
                       std::make_move_iterator(added_origins.end()));
        findings.insert(findings.end(), std::make_move_iterator(index.findings.begin()),
                        std::make_move_iterator(index.findings.end()));
        number();
    }

    [[nodiscard]] LoadedMesh read(const Origin& origin) const {
        if (origin.record.entry.triangles == 0) return {.mesh = {.name = origin.record.entry.name}};
        const Source& source = sources[origin.source];
        const CacheKey key = mesh_key(source.key, origin.record, options);
        if (options.use_cache)
            if (auto kept = cache.mesh(key)) return std::move(*kept);
        const auto files = open_source(source.path, source.kind);
        const RawMesh raw = read_model(*files, origin.record.model, ReadImages::Yes, options.texture_side);
        LoadedMesh loaded =
            decimated(fitted(raw, origin.record.fitting, origin.record.entry.name), options.object_triangles);
        if (options.use_cache) cache.keep(key, loaded);
        return loaded;
    }
};

Catalogue::Catalogue(const CatalogueOptions& options) : state_(std::make_unique<State>()) {
    state_->options = options;
    state_->cache = Cache(options.cache.empty() ? default_cache() : options.cache);
    state_->add_own();
}

Catalogue::~Catalogue() = default;
Catalogue::Catalogue(Catalogue&&) noexcept = default;
Catalogue& Catalogue::operator=(Catalogue&&) noexcept = default;

void Catalogue::add(const std::filesystem::path& path, const accel::Executor& executor) {
    Source source{path, source_kind(path), {}};
    source.key = source_key(path, source.kind);
    std::optional<SourceIndex> index;
    if (state_->options.use_cache) index = state_->cache.index(source.key);
    if (!index) {
        index = read_source(path, executor);
        refuse_if_useless(path, *index);
        if (state_->options.use_cache) state_->cache.keep(source.key, *index);
    }
    state_->sources.push_back(std::move(source));
    state_->insert(std::move(*index), state_->sources.size() - 1, path.stem().string());
}

std::span<const CatalogueEntry> Catalogue::entries() const { return state_->entries; }

const CatalogueEntry* Catalogue::find(std::string_view id) const {
    if (const auto found = state_->by_id.find(id); found != state_->by_id.end()) return &state_->entries[found->second];
    if (const auto found = state_->by_alias.find(id); found != state_->by_alias.end())
        return &state_->entries[found->second];
    return nullptr;
}

const CatalogueEntry* Catalogue::find_in(std::string_view source, std::string_view model) const {
    for (std::size_t k = 0; k < state_->entries.size(); ++k)
        if (state_->origins[k].record.alias == model && !model.empty() && state_->entries[k].source == source)
            return &state_->entries[k];
    return nullptr;
}

std::vector<const CatalogueEntry*> Catalogue::of_kind(std::string_view kind) const {
    std::vector<const CatalogueEntry*> found;
    for (const CatalogueEntry& entry : state_->entries)
        if (entry.kind == kind && !kind.empty()) found.push_back(&entry);
    return found;
}

LoadedMesh Catalogue::load(const CatalogueEntry& entry) const {
    const auto found = state_->by_id.find(entry.id);
    if (found == state_->by_id.end())
        throw InputError("K107", entry.source, "The catalogue has no entry " + entry.id + ".");
    const Origin& origin = state_->origins[found->second];
    if (origin.own == nullptr) return state_->read(origin);
    LoadedMesh loaded;
    loaded.mesh = origin.own->make(state_->options.detail);
    loaded.triangles_before = static_cast<std::uint32_t>(loaded.mesh.triangles.size());
    return loaded;
}

std::span<const Finding> Catalogue::findings() const { return state_->findings; }

}  // namespace enfilade::modeler
