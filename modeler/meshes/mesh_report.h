#pragma once
// Findings about a mesh, in the words of its file.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "modeler/check.h"
#include "modeler/meshes/mesh.h"

namespace enfilade::modeler {

/// Cells that a finding blames already.
struct MeshBlame {
    std::vector<bool> face;     ///< [face]
    std::vector<bool> crowded;  ///< [face] at an edge with more than two faces
    std::vector<bool> vertex;   ///< [vertex]
    std::vector<bool> rim;      ///< [vertex] at an edge with one face
};

/// Collects findings. Of each kind the first `MeshOptions::listed` are given one by one, the others as one number.
class MeshReport {
public:
    MeshReport(const Mesh& mesh, const MeshOptions& options, CheckReport& report);

    /// `kind` names the rest in the plural: "holes".
    void add(Finding finding, const char* kind);
    /// The findings that `add` held back, as one a kind.
    void finish();
    void suppress(std::uint64_t count = 1) { report_.suppressed += count; }
    void applied(std::initializer_list<const char*> codes);

    /// Numbers as the file counts them, without a word before them.
    [[nodiscard]] std::string vertex(std::uint32_t v) const;
    [[nodiscard]] std::string face(std::uint32_t f) const;
    /// "4, 7, 12, ..." of at most six.
    [[nodiscard]] std::string vertices(const std::vector<std::uint32_t>& list) const;
    [[nodiscard]] std::string faces(const std::vector<std::uint32_t>& list) const;
    /// `solid "x"`, or nothing where the file names none.
    [[nodiscard]] std::string owner(std::uint32_t face) const;

    /// Place and elements of a finding.
    void put_at(Finding& finding, const std::array<double, 3>& point) const { finding.point = point; }
    void name_face(Finding& finding, std::uint32_t f) const;
    void name_vertex(Finding& finding, std::uint32_t v) const;
    /// The solid, shell or group that the face belongs to.
    void name_owner(Finding& finding, std::uint32_t f) const;

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const MeshOptions& options() const { return options_; }

    MeshBlame blame;

private:
    struct Kind {
        std::uint64_t count = 0;
        Severity severity = Severity::Note;
        std::string code;
    };

    [[nodiscard]] const MeshSolid* solid_of(std::uint32_t face, std::uint32_t& shell) const;

    const Mesh& mesh_;
    const MeshOptions& options_;
    CheckReport& report_;
    std::map<std::string, Kind> kinds_;
};

/// A length as people read it: four digits.
[[nodiscard]] std::string short_number(double value);

}  // namespace enfilade::modeler
