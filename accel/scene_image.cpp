#include "accel/scene_image.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include "accel/sha256.h"
#include "accel/validate.h"
#include "base/error.h"

namespace enfilade::accel::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "scene files are mapped as they are: little-endian only");

constexpr std::array<char, 8> magic = {'E', 'N', 'F', 'I', 'L', 'A', 'D', 'E'};
constexpr std::uint32_t byte_order_mark = 0x01020304;
constexpr std::uint32_t section_count_limit = 4096;

std::size_t aligned(std::size_t offset) {
    return (offset + scene_file_alignment - 1) / scene_file_alignment * scene_file_alignment;
}

Sha256 hash_of_header(FileHeader header, std::span<const std::byte> table) {
    header.header_sha256 = {};
    std::vector<std::byte> bytes(sizeof header + table.size());
    std::memcpy(bytes.data(), &header, sizeof header);
    if (!table.empty()) std::memcpy(bytes.data() + sizeof header, table.data(), table.size());
    return sha256(bytes);
}

class Parser {
public:
    Parser(Scene::Storage storage, std::string file_name)
        : storage_(std::move(storage)), bytes_(storage_.bytes.get(), storage_.size), file_name_(std::move(file_name)) {}

    Scene parse() {
        const FileHeader header = read_header();
        SceneView view;
        view.unit = header.unit;
        for (int i = 0; i < 3; ++i) view.origin[i] = header.origin[i];
        std::vector<SceneArray> arrays;
        arrays.reserve(header.section_count);
        for (std::uint32_t i = 0; i < header.section_count; ++i) {
            arrays.push_back(read_entry(header, i));
            bind(view, arrays.back());
        }
        return {std::move(storage_), view, std::move(arrays)};
    }

private:
    [[noreturn]] void refuse(const char* code, const std::string& sentence) const {
        throw InputError(code, file_name_, sentence + "; build the scene again from its plan");
    }

    FileHeader read_header() const {
        FileHeader header;
        if (bytes_.size() < sizeof header) refuse("F1", "this is no scene file: it is shorter than a header");
        std::memcpy(&header, bytes_.data(), sizeof header);
        if (header.magic != magic) refuse("F1", "this is no scene file: it does not begin with ENFILADE");
        if (header.byte_order != byte_order_mark) refuse("F1", "the scene file has a foreign byte order");
        if (header.version != scene_file_version)
            refuse("F1", "the scene file has version " + std::to_string(header.version) + ", this program reads " +
                             std::to_string(scene_file_version));
        if (header.file_bytes != bytes_.size())
            refuse("F2", "the scene file is damaged: it states " + std::to_string(header.file_bytes) +
                             " bytes and has " + std::to_string(bytes_.size()));
        if (header.section_entry_bytes != sizeof(SectionEntry) || header.section_count > section_count_limit ||
            sizeof header + header.section_count * sizeof(SectionEntry) > bytes_.size())
            refuse("F2", "the scene file's section table does not fit into the file");
        const auto table = bytes_.subspan(sizeof header, header.section_count * sizeof(SectionEntry));
        if (hash_of_header(header, table) != header.header_sha256)
            refuse("F2", "the scene file is damaged: header and section table do not have their SHA-256");
        int exponent = 0;
        if (!(header.unit > 0) || !std::isfinite(header.unit) || std::frexp(header.unit, &exponent) != 0.5 ||
            exponent < -60 || exponent > 60)
            refuse("F5", "the scene's grid unit is no power of two");
        for (const double coordinate : header.origin)
            if (!std::isfinite(coordinate)) refuse("F5", "the scene's origin is not finite");
        return header;
    }

    SceneArray read_entry(const FileHeader& header, std::uint32_t i) const {
        SectionEntry entry;
        std::memcpy(&entry, bytes_.data() + sizeof header + i * sizeof entry, sizeof entry);
        const auto* name = reinterpret_cast<const char*>(bytes_.data() + sizeof header + i * sizeof entry);
        const std::size_t length = ::strnlen(name, entry.name.size());
        const std::string where = "section " + std::to_string(i) + " of the scene file ";
        if (length == entry.name.size()) refuse("F2", where + "has a name that does not end");
        const std::size_t table_end = sizeof header + header.section_count * sizeof entry;
        if (entry.offset % scene_file_alignment != 0 || entry.offset < table_end || entry.offset > bytes_.size() ||
            entry.bytes > bytes_.size() - entry.offset ||
            bytes_.size() - entry.offset - entry.bytes < scene_file_alignment)
            refuse("F2", where + "lies outside the file");
        if (entry.element_bytes == 0 || entry.bytes % entry.element_bytes != 0)
            refuse("F2", where + "holds no whole number of elements");
        return {{name, length}, entry.id, entry.group, entry.element_bytes, bytes_.subspan(entry.offset, entry.bytes),
                entry.sha256};
    }

    template <class T>
    void bind_one(ArrayView<T>& array, const SceneArray& source) const {
        const std::string name(source.name);
        if (source.element_bytes != sizeof(T))
            refuse("F3", "the array " + name + " has elements of " + std::to_string(source.element_bytes) +
                             " bytes instead of " + std::to_string(sizeof(T)));
        if (array.first != nullptr) refuse("F3", "the array " + name + " is there twice");
        array.first = reinterpret_cast<const T*>(source.bytes.data());
        array.count = source.bytes.size() / sizeof(T);
    }

    void bind(SceneView& view, const SceneArray& array) const {
        if (array.group != Group::Trace) return;
        switch (static_cast<SectionKind>(array.id)) {
            case SectionKind::Cells: return bind_one(view.cells, array);
            case SectionKind::CellPortals: return bind_one(view.cell_portals, array);
            case SectionKind::SectionX: return bind_one(view.section_x, array);
            case SectionKind::SectionY: return bind_one(view.section_y, array);
            case SectionKind::SectionTails: return bind_one(view.section_tails, array);
            case SectionKind::SideFaces: return bind_one(view.side_faces, array);
            case SectionKind::SideFacePortals: return bind_one(view.side_face_portals, array);
            case SectionKind::Portals: return bind_one(view.portals, array);
            case SectionKind::Tints: return bind_one(view.tints, array);
            case SectionKind::SourceFaces: return bind_one(view.source_faces, array);
            case SectionKind::Vertices: return bind_one(view.vertices, array);
            case SectionKind::Materials: return bind_one(view.materials, array);
            case SectionKind::Spaces: return bind_one(view.spaces, array);
            case SectionKind::TextOffsets: return bind_one(view.text_offsets, array);
            case SectionKind::Text: return bind_one(view.text, array);
            case SectionKind::LocatorNodes: return bind_one(view.locator_nodes, array);
            case SectionKind::LocatorCells: return bind_one(view.locator_cells, array);
            case SectionKind::Meshes: return bind_one(view.meshes, array);
            case SectionKind::MeshVertices: return bind_one(view.mesh_vertices, array);
            case SectionKind::MeshTriangles: return bind_one(view.mesh_triangles, array);
            case SectionKind::Objects: return bind_one(view.objects, array);
            case SectionKind::CellObjectOffsets: return bind_one(view.cell_object_offsets, array);
            case SectionKind::CellObjects: return bind_one(view.cell_objects, array);
            case SectionKind::Lights: return bind_one(view.lights, array);
            case SectionKind::MaterialLooks: return bind_one(view.material_looks, array);
            case SectionKind::Textures: return bind_one(view.textures, array);
            case SectionKind::Texels: return bind_one(view.texels, array);
            case SectionKind::MeshTexCoords: return bind_one(view.mesh_texcoords, array);
            case SectionKind::FaceFrames: return bind_one(view.face_frames, array);
            default: return;  // a section of a later version: carried, not used
        }
    }

    Scene::Storage storage_;
    std::span<const std::byte> bytes_;
    std::string file_name_;
};

}  // namespace

std::shared_ptr<std::byte> allocate_aligned(std::size_t size) {
    const std::size_t rounded = aligned(std::max<std::size_t>(size, 1));
    auto* bytes = static_cast<std::byte*>(std::aligned_alloc(scene_file_alignment, rounded));
    if (bytes == nullptr) throw std::bad_alloc();
    std::memset(bytes, 0, rounded);
    return {bytes, [](std::byte* p) { std::free(p); }};
}

Scene::Storage lay_out(double unit, const std::array<double, 3>& origin, std::span<const SceneArray> arrays) {
    std::vector<SectionEntry> table(arrays.size());
    std::size_t end = aligned(sizeof(FileHeader) + arrays.size() * sizeof(SectionEntry));
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        SectionEntry& entry = table[i];
        entry = {};
        arrays[i].name.copy(entry.name.data(), entry.name.size() - 1);
        entry.id = arrays[i].id;
        entry.group = arrays[i].group;
        entry.element_bytes = arrays[i].element_bytes;
        entry.offset = end;
        entry.bytes = arrays[i].bytes.size();
        entry.sha256 = arrays[i].sha256;
        end = aligned(end + entry.bytes + scene_file_alignment);
    }
    FileHeader header = {};
    header.magic = magic;
    header.version = scene_file_version;
    header.byte_order = byte_order_mark;
    header.file_bytes = end;
    header.section_count = static_cast<std::uint32_t>(arrays.size());
    header.section_entry_bytes = sizeof(SectionEntry);
    header.unit = unit;
    header.origin = origin;
    header.header_sha256 = hash_of_header(header, std::as_bytes(std::span(table)));

    const std::shared_ptr<std::byte> bytes = allocate_aligned(end);
    std::memcpy(bytes.get(), &header, sizeof header);
    std::memcpy(bytes.get() + sizeof header, table.data(), table.size() * sizeof(SectionEntry));
    for (std::size_t i = 0; i < arrays.size(); ++i)
        if (!arrays[i].bytes.empty())
            std::memcpy(bytes.get() + table[i].offset, arrays[i].bytes.data(), arrays[i].bytes.size());
    return {bytes, end};
}

Scene parse(Scene::Storage storage, const std::string& file_name) {
    return Parser(std::move(storage), file_name).parse();
}

Scene parse_and_validate(Scene::Storage storage, const std::string& file_name, const ReadOptions& options) {
    Scene scene = parse(std::move(storage), file_name);
    const ThreadExecutor all_cores;
    const Executor& executor = options.executor != nullptr ? *options.executor : all_cores;
    const std::vector<Defect> defects = validate(scene.view(), executor);
    if (!defects.empty()) {
        const std::string more = defects.size() > 1 ? " (and " + std::to_string(defects.size() - 1) + " more)" : "";
        throw InputError(
            defects.front().code, file_name,
            "the scene file is damaged: " + defects.front().sentence + more + "; build the scene again from its plan");
    }
    if (options.verify_hashes) {
        const std::vector<std::string> damaged = damaged_arrays(scene, &executor);
        if (!damaged.empty())
            throw InputError("F2", file_name,
                             "the scene file is damaged: the array " + damaged.front() +
                                 " does not have its SHA-256; build the scene again from its plan");
    }
    return scene;
}

}  // namespace enfilade::accel::detail
