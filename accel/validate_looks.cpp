#include "accel/defect_report.h"
#include "accel/texture_chain.h"

namespace enfilade::accel::detail {
namespace {

// Lookups take numbers of repeats apart into whole ones and the rest: beyond this nothing is left of the rest.
constexpr float repeat_limit = 1e6f;
constexpr float frame_limit = 1e12f;

class LookValidator {
public:
    LookValidator(const SceneView& view, const Executor& executor, DefectReport& report)
        : view_(view), executor_(executor), report_(report) {}

    void run() {
        if (!have_sizes() || !check_texture_shares()) return;
        check_material_looks();
        check_mesh_texcoords();
        check_face_frames();
    }

private:
    bool have_sizes() {
        const SceneView& v = view_;
        bool all = true;
        const auto need = [&](bool holds, const char* sentence) {
            if (!holds) report_.add(0, "F3", sentence);
            all = all && holds;
        };
        need(v.textures.size() < UINT32_MAX && v.texels.size() <= UINT32_MAX && v.mesh_texcoords.size() < UINT32_MAX,
             "an array of textures is too long");
        need(v.material_looks.empty() || v.material_looks.size() == v.materials.size(),
             "the array material_looks has not one entry a material");
        need(v.face_frames.empty() || v.face_frames.size() == v.source_face_count(),
             "the array face_frames has not one entry a source face");
        return all;
    }

    /// Textures lie one after the other, each with all its levels.
    bool check_texture_shares() {
        const SceneView& v = view_;
        std::uint64_t next = 0;
        for (std::size_t i = 0; i < v.textures.size(); ++i) {
            const Texture& t = v.textures[i];
            const bool is_sound = t.first_texel == next && t.width > 0 && t.height > 0 &&
                                  t.level_count == level_count(t.width, t.height) &&
                                  index(t.name) + 1 < v.text_offsets.size();
            if (!is_sound) {
                report_.add(i, "F4",
                            element("textures", i) + " does not begin where the one before ends, or lacks levels");
                return false;
            }
            next += texel_count(t.width, t.height);
        }
        if (next == v.texels.size()) return true;
        report_.add(v.textures.size(), "F4", "the textures do not share out the array texels");
        return false;
    }

    void check_material_looks() {
        const SceneView& v = view_;
        check_each(
            executor_, v.material_looks.size(),
            [&](std::size_t i) {
                const TextureId texture = v.material_looks[i].texture;
                return texture == none<TextureId> || index(texture) < v.textures.size();
            },
            [&](std::size_t i) { report_.add(i, "F4", element("material_looks", i) + " names no texture"); });
        check_each(
            executor_, v.material_looks.size(), [&](std::size_t i) { return is_sound(v.material_looks[i]); },
            [&](std::size_t i) {
                report_.add(i, "F5", element("material_looks", i) + " gives more light than it gets, or is no number");
            });
    }

    [[nodiscard]] static bool is_sound(const MaterialLook& look) {
        constexpr float all_light = 1 + 0x1p-20f;  // shares are sums that were rounded
        if (!(look.mirror >= 0)) return false;
        for (const float part : look.through)
            if (!(part >= 0 && look.mirror + part <= all_light)) return false;
        for (const float number : look.texture_from_face)
            if (!(std::abs(number) <= repeat_limit)) return false;
        return look.mirror <= all_light;
    }

    void check_mesh_texcoords() {
        const SceneView& v = view_;
        std::uint64_t next = 0;
        for (std::size_t m = 0; m < v.meshes.size(); ++m) {
            const ObjectMesh& mesh = v.meshes[m];
            if (mesh.texcoords == 0) continue;
            if (mesh.texcoords - 1 != next)
                return report_.add(m, "F4", element("meshes", m) + " does not share in the array mesh_texcoords");
            next += 3 * std::uint64_t{mesh.triangle_count};
        }
        if (next != v.mesh_texcoords.size())
            return report_.add(v.meshes.size(), "F4", "the meshes do not share out the array mesh_texcoords");
        check_each(
            executor_, v.mesh_texcoords.size(),
            [&](std::size_t i) {
                return std::abs(v.mesh_texcoords[i].u) <= repeat_limit &&
                       std::abs(v.mesh_texcoords[i].v) <= repeat_limit;
            },
            [&](std::size_t i) { report_.add(i, "F5", element("mesh_texcoords", i) + " is no place on a texture"); });
    }

    void check_face_frames() {
        const SceneView& v = view_;
        check_each(
            executor_, v.face_frames.size(),
            [&](std::size_t i) {
                const FaceFrame& f = v.face_frames[i];
                const float square = f.x_u * f.x_u + f.y_u * f.y_u;
                return square > 0.99f && square < 1.01f && std::abs(f.u_0) <= frame_limit &&
                       std::abs(f.v_0) <= frame_limit;
            },
            [&](std::size_t i) { report_.add(i, "F5", element("face_frames", i) + " is no frame of length 1"); });
    }

    const SceneView& view_;
    const Executor& executor_;
    DefectReport& report_;
};

}  // namespace

void validate_looks(const SceneView& view, const Executor& executor, DefectReport& report) {
    LookValidator(view, executor, report).run();
}

}  // namespace enfilade::accel::detail
