#include "tools/object_accel.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.h"
#include "plans/number_text.h"
#include "render/octree_counter.h"
#include "tools/bench.h"
#include "tools/console.h"

namespace enfilade::tools {

namespace {

/// The first flag of octrees that was given; empty: none.
std::string given_octree_flag(const ObjectAccelFlags& flags) {
    if (flags.octree_depth) return "--octree-depth";
    if (flags.octree_leaf) return "--octree-leaf";
    if (flags.octree_balance) return "--octree-balance";
    if (!flags.octree_layout.empty()) return "--octree-layout";
    return flags.octree_real.empty() ? "" : "--octree-real";
}

render::ObjectAccelKind kind_of(const std::string& name) {
    if (name.empty()) return render::ObjectAccelKind::Automatic;
    if (name == "octree") return render::ObjectAccelKind::Octree;
    return name == "plain" ? render::ObjectAccelKind::Plain : render::ObjectAccelKind::Bvh;
}

/// Triangles of the meshes that some object has.
std::size_t triangle_count(const accel::SceneView& scene) {
    std::vector<bool> counted(scene.meshes.size(), false);
    std::size_t sum = 0;
    for (const accel::PlacedObject& object : scene.objects) {
        if (counted[index(object.mesh)]) continue;
        counted[index(object.mesh)] = true;
        sum += scene.meshes[index(object.mesh)].triangle_count;
    }
    return sum;
}

const char* layout_name(const accel::OctreeOptions& asked) {
    if (asked.layout == accel::OctreeLayout::Linked) return "linked";
    return asked.has_stored_boxes ? "stored" : "ropes";
}

const char* real_name(const accel::OctreeOptions& asked) { return asked.walks_in_double ? "double" : "float"; }

/// "linked, float, depth 5 at most, leaves by the mesh, balanced": as the flags say it.
std::string words_of(const accel::OctreeOptions& asked) {
    constexpr std::uint32_t automatic = accel::OctreeOptions::automatic;
    return std::string(layout_name(asked)) + ", " + real_name(asked) + ", depth " +
           (asked.depth == automatic ? "by the mesh" : std::to_string(asked.depth) + " at most") + ", leaves " +
           (asked.leaf_size == automatic ? "by the mesh" : "split above " + counted(asked.leaf_size, "triangle")) +
           (asked.is_balanced ? ", balanced" : ", not balanced");
}

/// Depth and leaf: null where the mesh decides.
nlohmann::ordered_json json_of(const accel::OctreeOptions& asked) {
    const auto number = [](std::uint32_t value) {
        return value == accel::OctreeOptions::automatic ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
    };
    return {{"layout", layout_name(asked)},
            {"real", real_name(asked)},
            {"depth", number(asked.depth)},
            {"leaf", number(asked.leaf_size)},
            {"balance", asked.is_balanced}};
}

double per(std::size_t part, std::size_t whole) { return whole == 0 ? 0 : double(part) / double(whole); }

std::string line(const char* name, const std::string& value) {
    std::string text = "  " + std::string(name);
    text.resize(24, ' ');
    return text + value + '\n';
}

}  // namespace

void refuse_object_accel(const ObjectAccelFlags& flags, const std::string& why) {
    const std::string flag = flags.kind.empty() ? given_octree_flag(flags) : "--object-accel";
    if (!flag.empty()) throw InputError("F139", "", why + ", so " + flag + " changes nothing: leave it out.");
}

ObjectAccelChoice object_accel_choice(const ObjectAccelFlags& flags, const std::string& asker) {
    const std::string octree_flag = given_octree_flag(flags);
    if (!asker.empty() && !flags.kind.empty() && flags.kind != "octree")
        throw InputError(
            "F139", "",
            asker + " counts what rays do in octrees: leave out --object-accel " + flags.kind + ", or give it octree.");
    if (asker.empty() && flags.kind != "octree" && !octree_flag.empty())
        throw InputError("F139", "",
                         octree_flag + " is for octrees: give --object-accel octree " +
                             (flags.kind.empty() ? "as well" : "instead of " + flags.kind) + ", or leave it out.");
    ObjectAccelChoice choice;
    choice.kind = asker.empty() ? kind_of(flags.kind) : render::ObjectAccelKind::Octree;
    if (flags.octree_depth) choice.octree.depth = *flags.octree_depth;
    if (flags.octree_leaf) choice.octree.leaf_size = *flags.octree_leaf;
    choice.octree.is_balanced = flags.octree_balance;
    const bool is_papers = flags.octree_layout == "ropes" || flags.octree_layout == "stored";
    if (!flags.octree_real.empty() && !is_papers)
        throw InputError(
            "F139", "",
            "--octree-real is for the paper's walk: give --octree-layout ropes or stored as well, or leave it out.");
    choice.octree.layout = is_papers ? accel::OctreeLayout::Ropes : accel::OctreeLayout::Linked;
    choice.octree.has_stored_boxes = flags.octree_layout == "stored";
    choice.octree.walks_in_double = flags.octree_real == "double";
    return choice;
}

ObjectsSummary counted_objects(const accel::SceneView& scene) {
    ObjectsSummary summary;
    if (!scene.has_objects()) return summary;
    summary.count = scene.objects.size();
    summary.triangles = triangle_count(scene);
    return summary;
}

PreparedObjects prepare_objects(const accel::SceneView& scene, const ObjectAccelChoice& choice,
                                const accel::Executor& executor) {
    PreparedObjects prepared;
    if (!scene.has_objects()) return prepared;
    ObjectsSummary& summary = prepared.summary;
    summary = counted_objects(scene);
    summary.seconds =
        seconds_of([&] { prepared.accel = render::build_object_accel(scene, choice.kind, executor, choice.octree); });
    summary.accel = prepared.accel->name();
    summary.bytes = prepared.accel->bytes();
    if (const render::OctreeCounter* octrees = prepared.accel->octrees()) summary.octrees = octrees->figures();
    summary.asked = choice.octree;
    return prepared;
}

std::string ObjectsSummary::report() const {
    if (count == 0) return {};
    std::string text =
        line("objects", counted(count, "object") + ", " + counted(triangles, "triangle") + " of their meshes");
    text += line("inside them", accel + ", built in " + time_text(seconds));
    text +=
        line("bytes", byte_text(double(bytes)) + ", " + plans::rounded_text(per(bytes, triangles), 1) + " a triangle");
    if (!octrees) return text;
    text += line("octrees as asked", words_of(asked));
    text += line("leaves", grouped(octrees->leaves) + ", " + grouped(octrees->empty_leaves) + " of them empty, in " +
                               counted(octrees->trees, "octree"));
    text += line("references", plans::rounded_text(per(octrees->references, triangles), 2) + " a triangle");
    return text + line("depth", std::to_string(octrees->depth));
}

nlohmann::ordered_json ObjectsSummary::json() const {
    if (count == 0) return nullptr;
    nlohmann::ordered_json json = {{"count", count},
                                   {"triangles", triangles},
                                   {"accel", accel},
                                   {"bytes", bytes},
                                   {"bytes_per_triangle", per(bytes, triangles)},
                                   {"seconds", seconds}};
    if (octrees)
        json["octree"] = {{"trees", octrees->trees},
                          {"leaves", octrees->leaves},
                          {"empty_leaves", octrees->empty_leaves},
                          {"references", octrees->references},
                          {"references_per_triangle", per(octrees->references, triangles)},
                          {"depth", octrees->depth},
                          {"asked", json_of(asked)}};
    return json;
}

}  // namespace enfilade::tools
