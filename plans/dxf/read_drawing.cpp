#include <dl_dxf.h>

#include <istream>

#include "base/error.h"
#include "plans/dxf/drawing.h"
#include "plans/dxf/events.h"
#include "plans/dxf/explode.h"
#include "plans/dxf/pairs.h"
#include "plans/dxf/record_source.h"

namespace enfilade::plans {

Drawing read_drawing(std::string_view bytes, const std::string& file_name, const DrawingLimits& limits) {
    // A vertex takes up to four pairs.
    dxf::check_structure(bytes, file_name, std::size_t{4} * limits.strokes + 100);
    dxf::Contents contents;
    dxf::RecordSource source(bytes, contents.left_out);
    dxf::Events events(contents, source, limits.strokes);
    {
        std::istream stream(&source);
        DL_Dxf().in(stream, &events);
    }
    if (events.full_line() != 0)
        throw InputError("P708", file_name, events.full_line(), 0,
                         "The drawing holds more than " + std::to_string(limits.strokes) +
                             " entities and vertices; remove what the plan does not need.");
    return dxf::explode(contents, limits, file_name);
}

}  // namespace enfilade::plans
