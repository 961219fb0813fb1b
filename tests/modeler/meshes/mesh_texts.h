#pragma once
// Small meshes as text, and how a reader refuses one.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "modeler/meshes/mesh.h"
#include "tests/modeler/meshes/polyhedra.h"

namespace enfilade::modeler::test {

inline std::vector<Ring> rings(const Mesh& mesh) {
    std::vector<Ring> result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) result.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    return result;
}

/// Code, line and sentence of the refusal; a test fails where the text is read.
inline InputError refusal(const std::string& bytes, const std::string& name) {
    try {
        (void)read_mesh(bytes, name);
    } catch (const InputError& error) {
        return error;
    }
    ADD_FAILURE() << name << " was read";
    return {"", "", ""};
}

inline void expect_refused(const std::string& bytes, const std::string& name, const std::string& code, int line,
                           const std::string& part) {
    const InputError error = refusal(bytes, name);
    EXPECT_EQ(error.code, code) << error.what();
    EXPECT_EQ(error.line, line) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_EQ(error.file, name);
}

/// Numbers as the bytes of a binary file.
template <class T>
void put(std::string& bytes, T value, bool big_endian = false) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (big_endian) bytes.append(raw.rbegin(), raw.rend());
    else bytes.append(raw.begin(), raw.end());
}

inline const std::string tetrahedron_off =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
inline const std::vector<Ring> tetrahedron_rings = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

}  // namespace enfilade::modeler::test
