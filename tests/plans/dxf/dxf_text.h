#pragma once
// DXF texts put together pair by pair, for tests.

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "plans/dxf/drawing.h"
#include "plans/number_text.h"

namespace enfilade::plans::dxf_text {

/// A value as a line of the file.
struct Value {
    std::string text;
    Value(const char* t) : text(t) {}
    Value(std::string t) : text(std::move(t)) {}
    Value(double number) : text(number_text(number)) {}
    Value(int number) : text(std::to_string(number)) {}
};

inline std::string pair(int code, const Value& value) {
    std::string digits = std::to_string(code);
    if (digits.size() < 3) digits.insert(0, 3 - digits.size(), ' ');
    return digits + "\n" + value.text + "\n";
}

using Pairs = std::initializer_list<std::pair<int, Value>>;

inline std::string pairs(Pairs list) {
    std::string out;
    for (const auto& [code, value] : list) out += pair(code, value);
    return out;
}

inline std::string entity(const char* kind, Pairs list) { return pair(0, kind) + pairs(list); }

inline std::string line(double x0, double y0, double x1, double y1, const char* layer = "0") {
    return entity("LINE", {{8, layer}, {10, x0}, {20, y0}, {11, x1}, {21, y1}});
}

inline std::string section(const char* name, const std::string& body) {
    return pairs({{0, "SECTION"}, {2, name}}) + body + pair(0, "ENDSEC");
}

inline std::string block(const char* name, const std::string& entities, double x = 0, double y = 0) {
    return entity("BLOCK", {{8, "0"}, {2, name}, {70, 0}, {10, x}, {20, y}}) + entities + entity("ENDBLK", {{8, "0"}});
}

inline std::string layer(const char* name, int flags = 0, int colour = 7) {
    return entity("LAYER", {{2, name}, {70, flags}, {62, colour}});
}

/// What stands in the sections of a file; empty ones are not written.
struct File {
    std::string entities;
    std::string blocks = {};
    std::string header = {};  ///< pairs of code 9 and what belongs to them
    std::string layers = {};

    [[nodiscard]] std::string text() const {
        std::string out;
        if (!header.empty()) out += section("HEADER", header);
        if (!layers.empty()) out += section("TABLES", pairs({{0, "TABLE"}, {2, "LAYER"}}) + layers + pair(0, "ENDTAB"));
        if (!blocks.empty()) out += section("BLOCKS", blocks);
        return out + section("ENTITIES", entities) + pair(0, "EOF");
    }
};

inline Drawing read(const File& file, const DrawingLimits& limits = {}) {
    return read_drawing(file.text(), "test.dxf", limits);
}

inline Drawing read_entities(const std::string& entities) { return read({entities}); }

/// The refusal of the text; an empty code where it is read.
inline InputError refusal(const std::string& text, const DrawingLimits& limits = {}) {
    try {
        (void)read_drawing(text, "test.dxf", limits);
    } catch (const InputError& error) {
        return error;
    }
    return {"", "", "The text was read."};
}

/// Where the `nth` line stands that is exactly this one, from 1; 0: nowhere.
inline int line_of(const std::string& text, const std::string& wanted, int nth = 1) {
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        ++number;
        if (text.substr(at, end - at) == wanted && --nth == 0) return number;
        at = end == std::string::npos ? text.size() : end + 1;
    }
    return 0;
}

inline std::vector<Stroke> strokes_of(const Drawing& drawing, std::size_t shape) {
    const Shape& s = drawing.shapes.at(shape);
    return {drawing.strokes.begin() + s.first_stroke, drawing.strokes.begin() + s.first_stroke + s.stroke_count};
}

inline void expect_point(Point got, Point wanted, double tolerance = 1e-12) {
    EXPECT_NEAR(got.x, wanted.x, tolerance);
    EXPECT_NEAR(got.y, wanted.y, tolerance);
}

inline void expect_strokes(const Drawing& drawing, std::size_t shape, const std::vector<Stroke>& wanted,
                           double tolerance = 1e-12) {
    const std::vector<Stroke> got = strokes_of(drawing, shape);
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t k = 0; k < got.size(); ++k) {
        SCOPED_TRACE("stroke " + std::to_string(k));
        expect_point(got[k].a, wanted[k].a, tolerance);
        expect_point(got[k].b, wanted[k].b, tolerance);
        EXPECT_NEAR(got[k].bulge, wanted[k].bulge, tolerance);
    }
}

inline const Finding* finding_of(const Drawing& drawing, const std::string& code) {
    for (const Finding& finding : drawing.findings)
        if (finding.code == code) return &finding;
    return nullptr;
}

inline std::string sentence_of(const Drawing& drawing, const std::string& code) {
    const Finding* const finding = finding_of(drawing, code);
    return finding == nullptr ? "" : finding->sentence;
}

}  // namespace enfilade::plans::dxf_text
