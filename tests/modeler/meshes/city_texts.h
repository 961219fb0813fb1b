#pragma once
// City models of cubes, as text.

#include <array>
#include <string>
#include <vector>

namespace enfilade::modeler::test {

/// `[[x, y, z], ...]` of the corners of a box, in the order of `cube_rings`.
inline std::string box_vertices(std::array<double, 3> low, std::array<double, 3> high) {
    std::string text;
    for (int k = 0; k < 8; ++k) {
        const double p[] = {(k & 1) != 0 ? high[0] : low[0], (k & 2) != 0 ? high[1] : low[1],
                            (k & 4) != 0 ? high[2] : low[2]};
        text += std::string(k == 0 ? "" : ",") + "[" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," +
                std::to_string(p[2]) + "]";
    }
    return text;
}

/// The shell of a box whose corners are numbered from `first`, seen from outside counter-clockwise; or from inside.
inline std::string box_shell(int first, bool inward = false) {
    static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::string text = "[";
    for (int f = 0; f < 6; ++f) {
        text += f == 0 ? "[[" : ",[[";
        for (int k = 0; k < 4; ++k)
            text += std::string(k == 0 ? "" : ",") + std::to_string(first + faces[f][inward ? 3 - k : k]);
        text += "]]";
    }
    return text + "]";
}

inline std::string geometry(const std::string& type, const std::string& boundaries, const std::string& lod = "2.2") {
    return R"({"type":")" + type + R"(","lod":")" + lod + R"(","boundaries":)" + boundaries + "}";
}

inline std::string object(const std::string& id, const std::string& geometries, const std::string& type = "Building") {
    return "\"" + id + R"(":{"type":")" + type + R"(","attributes":{"a":[1,{"b":null}]},"geometry":[)" + geometries +
           "]}";
}

inline std::string city(const std::string& objects, const std::string& vertices, const std::string& more = "",
                        const std::string& version = "2.0") {
    return R"({"type":"CityJSON","version":")" + version + R"(","transform":{"scale":[1,1,1],"translate":[0,0,0]},)" +
           more + R"("CityObjects":{)" + objects + R"(},"vertices":[)" + vertices + "]}";
}

}  // namespace enfilade::modeler::test
