#include <algorithm>
#include <cmath>

#include "accel/defect_report.h"
#include "accel/placement.h"

namespace enfilade::accel::detail {
namespace {

// Magnitudes whose products stay far from infinity in float32.
constexpr float mesh_limit = 1e12f;
constexpr float placement_limit = 1e18f;

// Of the sum of magnitudes, how far a placement times its inverse may be from one: both are rounded to float32, twice
// and more for the sake of those who multiply placements before they round them.
constexpr double inverse_tolerance = 4e-6;

class ObjectValidator {
public:
    ObjectValidator(const SceneView& view, const Executor& executor, DefectReport& report)
        : view_(view), executor_(executor), report_(report) {}

    void run() {
        if (!have_sizes()) return;
        if (!check_mesh_shares()) return;
        check_mesh_vertices();
        check_mesh_triangles();
        check_objects();
        check_cell_lists();
    }

private:
    bool have_sizes() {
        const SceneView& v = view_;
        bool all = true;
        const auto need = [&](bool holds, const char* sentence) {
            if (!holds) report_.add(0, "F3", sentence);
            all = all && holds;
        };
        need(v.meshes.size() < UINT32_MAX && v.mesh_vertices.size() < UINT32_MAX &&
                 v.mesh_triangles.size() < UINT32_MAX && v.objects.size() < UINT32_MAX &&
                 v.cell_objects.size() < UINT32_MAX,
             "an array of furniture is too long");
        need(v.cell_object_offsets.size() == (v.has_objects() ? v.cells.size() + 1 : 0),
             "the array cell_object_off has not one entry a cell and one");
        need(v.has_objects() || v.cell_objects.empty(), "the array cell_objects is there without objects");
        return all;
    }

    [[nodiscard]] bool is_text(TextId id) const { return index(id) + 1 < view_.text_offsets.size(); }

    /// Meshes lie one after the other in both arrays.
    bool check_mesh_shares() {
        const SceneView& v = view_;
        std::uint64_t next_vertex = 0, next_triangle = 0;
        for (std::size_t m = 0; m < v.meshes.size(); ++m) {
            const ObjectMesh& mesh = v.meshes[m];
            if (mesh.first_vertex != next_vertex || mesh.first_triangle != next_triangle || !is_text(mesh.name)) {
                report_.add(m, "F4",
                            element("meshes", m) + " does not begin where the one before ends, or has no name");
                return false;
            }
            next_vertex += mesh.vertex_count;
            next_triangle += mesh.triangle_count;
        }
        if (next_vertex == v.mesh_vertices.size() && next_triangle == v.mesh_triangles.size()) return true;
        report_.add(v.meshes.size(), "F4", "the meshes do not share out the arrays mesh_vertices and mesh_triangles");
        return false;
    }

    /// The mesh that holds element i of an array; the elements of a chunk ask in ascending order.
    template <class First>
    [[nodiscard]] std::size_t mesh_of(std::size_t i, std::size_t guess, First first) const {
        const auto holds = [&](std::size_t m) {
            return first(m) <= i && (m + 1 == view_.meshes.size() || i < first(m + 1));
        };
        if (holds(guess)) return guess;
        // Empty meshes begin where others do: the last one that begins at or before the element holds it.
        std::size_t low = 0, high = view_.meshes.size();
        while (high - low > 1) (first((low + high) / 2) <= i ? low : high) = (low + high) / 2;
        return low;
    }

    /// Calls visit(mesh, i) for the elements of an array that meshes share out, until it is false.
    template <class First, class Visit>
    void for_each_share(std::size_t count, First first, Visit visit) {
        parallel_for(executor_, count, validate_grain, [&](std::size_t begin, std::size_t end) {
            std::size_t mesh = 0;
            for (std::size_t i = begin; i < end; ++i) {
                mesh = mesh_of(i, mesh, first);
                if (!visit(view_.meshes[mesh], i)) return;
            }
        });
    }

    void check_mesh_vertices() {
        const SceneView& v = view_;
        check_each(
            executor_, v.meshes.size(), [&](std::size_t m) { return has_sound_box(v.meshes[m]); },
            [&](std::size_t m) { report_.add(m, "F5", element("meshes", m) + " has a box that is none"); });
        for_each_share(
            v.mesh_vertices.size(), [&](std::size_t m) { return v.meshes[m].first_vertex; },
            [&](const ObjectMesh& mesh, std::size_t i) {
                const Vertex& p = v.mesh_vertices[i];
                const float at[3] = {p.x, p.y, p.z};
                bool is_sound = true;
                for (std::size_t k = 0; k < 3; ++k)
                    is_sound =
                        is_sound && std::abs(at[k]) <= mesh_limit && at[k] >= mesh.low[k] && at[k] <= mesh.high[k];
                if (!is_sound)
                    report_.add(i, "F5", element("mesh_vertices", i) + " is no number, or outside its mesh's box");
                return is_sound;
            });
    }

    [[nodiscard]] static bool has_sound_box(const ObjectMesh& mesh) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float low = mesh.low[k], high = mesh.high[k];
            const bool is_sound =
                mesh.vertex_count == 0 ? low > high : low <= high && low >= -mesh_limit && high <= mesh_limit;
            if (!is_sound) return false;
        }
        return true;
    }

    void check_mesh_triangles() {
        const SceneView& v = view_;
        for_each_share(
            v.mesh_triangles.size(), [&](std::size_t m) { return v.meshes[m].first_triangle; },
            [&](const ObjectMesh& mesh, std::size_t i) {
                const MeshTriangle& t = v.mesh_triangles[i];
                const bool is_sound = std::max({t.corners[0], t.corners[1], t.corners[2]}) < mesh.vertex_count &&
                                      index(t.material) < v.materials.size();
                if (!is_sound)
                    report_.add(i, "F4", element("mesh_triangles", i) + " has a corner or a material out of range");
                return is_sound;
            });
    }

    void check_objects() {
        const SceneView& v = view_;
        check_each(
            executor_, v.objects.size(),
            [&](std::size_t i) {
                const PlacedObject& o = v.objects[i];
                return index(o.mesh) < v.meshes.size() &&
                       (o.material == none<MaterialId> || index(o.material) < v.materials.size()) &&
                       index(o.space) < v.spaces.size() && is_text(o.id) && is_text(o.name);
            },
            [&](std::size_t i) { report_.add(i, "F4", element("objects", i) + " has an index out of range"); });
        if (!report_.empty()) return;
        check_each(
            executor_, v.objects.size(),
            [&](std::size_t i) { return i == 0 || v.string(v.objects[i - 1].id) < v.string(v.objects[i].id); },
            [&](std::size_t i) { report_.add(i, "F4", element("objects", i) + " has no id above the one before"); });
        check_each(
            executor_, v.objects.size(), [&](std::size_t i) { return is_sound_placement(v.objects[i]); },
            [&](std::size_t i) {
                report_.add(i, "F5", element("objects", i) + " has placements that are not each other's inverse");
            });
        if (!report_.empty()) return;
        check_each(
            executor_, v.objects.size(), [&](std::size_t i) { return is_inside_its_box(v.objects[i]); },
            [&](std::size_t i) { report_.add(i, "F5", element("objects", i) + " reaches out of its box"); });
    }

    [[nodiscard]] static bool is_sound_placement(const PlacedObject& object) {
        const auto& a = object.scene_from_object.rows;
        const auto& b = object.object_from_scene.rows;
        for (std::size_t k = 0; k < 12; ++k)
            if (!(std::abs(a[k]) <= placement_limit) || !(std::abs(b[k]) <= placement_limit)) return false;
        // a after b has to be the identity, up to what rounding does to either.
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 4; ++c) {
                double sum = c == 3 ? a[4 * r + 3] : 0, size = std::abs(sum);
                for (std::size_t k = 0; k < 3; ++k) {
                    const double product = double(a[4 * r + k]) * b[4 * k + c];
                    sum += product;
                    size += std::abs(product);
                }
                if (!(std::abs(sum - (r == c ? 1 : 0)) <= inverse_tolerance * std::max(size, 1.0))) return false;
            }
        return true;
    }

    [[nodiscard]] bool is_inside_its_box(const PlacedObject& object) const {
        const ObjectMesh& mesh = view_.meshes[index(object.mesh)];
        for (std::size_t k = 0; k < 3; ++k) {
            const float* row = object.scene_from_object.rows.data() + 4 * k;
            double low = row[3], high = row[3];
            for (std::size_t c = 0; c < 3 && mesh.vertex_count > 0; ++c) {
                const double one = double(row[c]) * mesh.low[c], other = double(row[c]) * mesh.high[c];
                low += std::min(one, other);
                high += std::max(one, other);
            }
            if (!(object.low[k] <= low) || !(object.high[k] >= high) || !is_finite(object.low[k]) ||
                !is_finite(object.high[k]))
                return false;
        }
        return true;
    }

    void check_cell_lists() {
        const SceneView& v = view_;
        if (!v.has_objects()) return;
        check_each(
            executor_, v.cells.size(),
            [&](std::size_t c) { return v.cell_object_offsets[c] <= v.cell_object_offsets[c + 1]; },
            [&](std::size_t c) { report_.add(c, "F4", element("cell_object_off", c) + " is not in order"); });
        if (v.cell_object_offsets[0] != 0 || v.cell_object_offsets[v.cells.size()] != v.cell_objects.size())
            report_.add(0, "F4", "the cells do not share out the array cell_objects");
        if (!report_.empty()) return;
        check_each(
            executor_, v.cells.size(),
            [&](std::size_t c) {
                const std::uint32_t begin = v.cell_object_offsets[c], end = v.cell_object_offsets[c + 1];
                for (std::uint32_t i = begin; i < end; ++i)
                    if (index(v.cell_objects[i]) >= v.objects.size() ||
                        (i > begin && v.cell_objects[i - 1] >= v.cell_objects[i]))
                        return false;
                return true;
            },
            [&](std::size_t c) {
                report_.add(c, "F4", "the list of " + element("cells", c) + " names no objects in ascending order");
            });
    }

    const SceneView& view_;
    const Executor& executor_;
    DefectReport& report_;
};

}  // namespace

void validate_objects(const SceneView& view, const Executor& executor, DefectReport& report) {
    ObjectValidator(view, executor, report).run();
}

}  // namespace enfilade::accel::detail
