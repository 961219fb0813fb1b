#pragma once
// Pictures lit by the scene's lamps: who they reach, how bright the pictures are, and what is told of it.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "accel/lights/light_clusters.h"
#include "accel/lights/light_trees.h"
#include "render/trace.h"
#include "tools/light_flags.h"
#include "tools/shots.h"

namespace enfilade::tools {

class LitPictures {
public:
    /// No lamp shines.
    LitPictures() = default;
    /// Follows the light of the scene's lamps, and looks how bright small pictures of the shots are where no exposure
    /// is chosen: one for all of a run, so that they compare. `is_linear`: the pictures are to hold candela / m2 (.exr
    /// without --exposure). A scene without lamps is lit as if none were asked for.
    LitPictures(const accel::SceneView& scene, const LightChoice& choice, std::span<const Shot> shots,
                render::TraceOptions how, bool is_linear);

    [[nodiscard]] bool are_lit() const { return lamp_count_ != 0; }
    /// Whether pictures hold candela / m2; else parts of white.
    [[nodiscard]] bool is_linear() const { return is_linear_; }
    [[nodiscard]] double ev() const { return ev_; }
    /// The scene with the lamps that stand for others: what pictures are to be made of, by everything that `light`
    /// lights. scene: that of the constructor, which has to live as long
    [[nodiscard]] accel::SceneView lit(accel::SceneView scene) const;
    /// Another exposure than the one that was found.
    void expose(double ev) { ev_ = ev; }
    /// Puts the lamps into the picture's options; with Shading::Look evening falls: the sun is gone, the sky dim, and
    /// what there is of light besides the lamps is --ambient.
    void light(render::TraceOptions& trace) const;

    /// "12 lamps, exposure 5.8 EV"
    [[nodiscard]] std::string text() const;
    /// Lines for a person: lists, beams, planes, bytes, time.
    [[nodiscard]] std::string report() const;
    /// null where no lamp shines
    [[nodiscard]] nlohmann::ordered_json json() const;

private:
    void meter(const accel::SceneView& scene, std::span<const Shot> shots, const render::TraceOptions& how);
    [[nodiscard]] render::LampOptions lamps(double exposure) const;
    [[nodiscard]] double ambient_lux() const;
    [[nodiscard]] accel::LightTreesView lists() const;
    [[nodiscard]] std::string cluster_report() const;

    LightChoice choice_;
    accel::LightTrees trees_;
    std::optional<accel::LightClusters> clusters_;
    std::size_t cell_count_ = 0;
    std::size_t lamp_count_ = 0;
    std::size_t walled_ = 0;  ///< lamps in solids
    double seconds_ = 0;      ///< that following their light took
    double cluster_seconds_ = 0;
    double ev_ = 0;
    bool is_linear_ = false;
};

}  // namespace enfilade::tools
