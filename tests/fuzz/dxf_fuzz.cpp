// Any bytes are either refused or a drawing whose parts hold together. Hardly a mutation of a DXF text would keep its
// pairs in step; so what does not speak of sections in full is taken line by line ("10 2.5"), put into pairs, and the
// sections and the end of the file are added where they lack.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "plans/dxf/drawing.h"

namespace {

using enfilade::plans::Drawing;
using enfilade::plans::Point;
using enfilade::plans::Shape;
using enfilade::plans::Stroke;

std::string drawing_of(std::string_view lines) {
    std::string out;
    bool inside = false;
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(lines.size(), line.size() + 1));
        const std::size_t space = line.find(' ');
        const std::string_view code = line.substr(0, space);
        if (code.empty() || code.size() > 4 || code.find_first_not_of("0123456789") != std::string_view::npos) continue;
        const std::string_view value = space == std::string_view::npos ? "" : line.substr(space + 1);
        if (value == "EOF") continue;
        if (value == "SECTION" && inside) out += "0\nENDSEC\n";
        else if (value == "ENDSEC" && !inside) continue;
        else if (value != "SECTION" && !inside) out += "0\nSECTION\n2\nENTITIES\n";
        inside = value != "ENDSEC";
        out += std::string(code) + "\n" + std::string(value) + "\n";
        if (value == "SECTION" && !lines.starts_with("2 ")) out += "2\nBLOCKS\n";
    }
    if (inside) out += "0\nENDSEC\n";
    return out + "0\nEOF\n";
}

void require(bool holds) {
    if (!holds) std::abort();
}

void check(const Drawing& drawing) {
    std::uint32_t next = 0;
    for (const Shape& shape : drawing.shapes) {
        require(shape.first_stroke == next && shape.stroke_count > 0 && shape.layer < drawing.layers.size());
        require(shape.block == UINT32_MAX || shape.block < drawing.insertions.size());
        next += shape.stroke_count;
        require(next <= drawing.strokes.size());
        for (std::uint32_t k = shape.first_stroke; k < next; ++k) {
            const Stroke& s = drawing.strokes[k];
            require(std::isfinite(s.a.x) && std::isfinite(s.a.y) && std::isfinite(s.b.x) && std::isfinite(s.b.y));
            require(std::isfinite(s.bulge));
            require(k + 1 == next || s.b == drawing.strokes[k + 1].a);
        }
    }
    require(next == drawing.strokes.size());
    for (std::size_t k = 0; k < drawing.insertions.size(); ++k)
        require(drawing.insertions[k].parent == UINT32_MAX || drawing.insertions[k].parent < k);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const bool whole = bytes.find("SECTION\n  2\n") != std::string_view::npos || bytes.find("\r\n") < 16;
    try {
        enfilade::plans::DrawingLimits limits;
        limits.strokes = 20'000;
        const Drawing drawing =
            enfilade::plans::read_drawing(whole ? std::string(bytes) : drawing_of(bytes), "fuzz.dxf", limits);
        check(drawing);
        const enfilade::plans::DrawingBox crop = {0, 0, 5, 5};
        check(select(drawing, {"*A*"}, crop, "fuzz.dxf"));
    } catch (const enfilade::InputError&) {
    }
    return 0;
}
