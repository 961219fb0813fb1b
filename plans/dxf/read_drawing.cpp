#include <dl_dxf.h>

#include <istream>

#include "plans/dxf/drawing.h"
#include "plans/dxf/events.h"
#include "plans/dxf/explode.h"
#include "plans/dxf/pairs.h"
#include "plans/dxf/record_source.h"

namespace enfilade::plans {

Drawing read_drawing(std::string_view bytes, const std::string& file_name, const DrawingLimits& limits) {
    dxf::check_structure(bytes, file_name);
    dxf::Contents contents;
    {
        dxf::RecordSource source(bytes, contents.left_out);
        std::istream stream(&source);
        dxf::Events events(contents, source);
        DL_Dxf().in(stream, &events);
    }
    return dxf::explode(contents, limits, file_name);
}

}  // namespace enfilade::plans
