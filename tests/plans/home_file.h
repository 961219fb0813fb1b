#pragma once
// Sweet Home 3D homes made in memory.

#include <zip.h>

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plans/read.h"

namespace enfilade::testing {

/// The bytes of a zip archive with these entries.
inline std::string archive(const std::vector<std::pair<std::string, std::string>>& entries) {
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(target);
    zip_t* zip = zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    if (zip == nullptr) throw std::runtime_error("no archive can be made in memory");
    for (const auto& [name, text] : entries) {
        zip_source_t* source = zip_source_buffer(zip, text.data(), text.size(), 0);
        if (zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8) < 0) throw std::runtime_error("no entry added");
    }
    if (zip_close(zip) != 0) throw std::runtime_error("the archive cannot be closed");
    zip_stat_t stat;
    zip_stat_init(&stat);
    zip_source_open(target);
    zip_source_stat(target, &stat);
    std::string bytes(stat.size, '\0');
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

inline plans::Plan read_archive(const std::string& bytes) {
    return plans::read_sweet_home(std::as_bytes(std::span(bytes)), "test.sh3d");
}

/// What stands between <home> and </home>, read.
inline plans::Plan read_home(const std::string& elements, const std::string& attributes = "wallHeight='250'") {
    return read_archive(archive(
        {{"Home.xml", "<?xml version='1.0'?>\n<home version='7200' " + attributes + ">" + elements + "</home>"}}));
}

/// A wall with its two ends in centimetres, y down as in the file.
inline std::string wall_xml(const std::string& id, double x0, double y0, double x1, double y1,
                            const std::string& more = "thickness='10'") {
    return "<wall id='" + id + "' xStart='" + std::to_string(x0) + "' yStart='" + std::to_string(y0) + "' xEnd='" +
           std::to_string(x1) + "' yEnd='" + std::to_string(y1) + "' " + more + "/>";
}

/// A door 90 cm wide, 10 cm deep and 200 cm high.
inline std::string door_xml(const std::string& id, double x, double y, const std::string& more = "") {
    return "<doorOrWindow id='" + id + "' catalogId='eTeks#door' name='Door " + id + "' x='" + std::to_string(x) +
           "' y='" + std::to_string(y) + "' width='90' depth='10' height='200' " + more + "/>";
}

/// The findings with this code.
inline std::vector<Finding> findings_of(const plans::Plan& plan, std::string_view code) {
    std::vector<Finding> found;
    for (const Finding& finding : plan.findings)
        if (finding.code == code) found.push_back(finding);
    return found;
}

}  // namespace enfilade::testing
