#pragma once
// What the model was checked for when it was exported, and the hashes of what was exported.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "accel/scene.h"
#include "accel/sha256.h"

namespace enfilade::accel {

/// Guards against accident, not against an adversary (1-architecture, decision 7 of the design).
struct Certificate {
    std::string program_version;
    std::string options;                                             ///< options of the build, JSON on one line
    std::vector<std::pair<std::string, std::uint64_t>> code_counts;  ///< checked codes and their findings
    std::string model_sha256;                                        ///< hex; empty if nothing was exported with it
    std::vector<std::pair<std::string, std::string>> trace_sha256;   ///< array name, hex
};

/// The scene's certificate, or nothing if it has none or it cannot be read.
[[nodiscard]] std::optional<Certificate> certificate(const Scene& scene);

/// SHA-256 over the hashes of the model group's arrays, in file order: what `Certificate::model_sha256` states.
[[nodiscard]] Sha256 model_hash(std::span<const SceneArray> arrays);

/// As text: one `key value` line each.
[[nodiscard]] std::string to_text(const Certificate& certificate);
[[nodiscard]] std::optional<Certificate> certificate_from_text(std::string_view text);

}  // namespace enfilade::accel
