// How plan files come in: the flags that `import`, `build` and `check` share, and the list of a drawing's layers.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "plans/dxf/drawing.h"
#include "tools/check_report.h"
#include "tools/commands.h"
#include "tools/exit_code.h"

namespace enfilade::tools {

plans::DrawingBox parse_crop(const std::string& text) {
    std::array<double, 4> numbers = {};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [stop, error] = std::from_chars(at, end, numbers[k]);
        const bool separated = k == 3 ? stop == end : stop != end && *stop == ',';
        if (error != std::errc() || !separated || !std::isfinite(numbers[k]))
            throw InputError("F103", "",
                             "--crop \"" + text +
                                 "\" is no box: give the coordinates of two opposite corners, like 0,0,12000,9000.");
        at = stop + 1;
    }
    const auto [x0, y0, x1, y1] = numbers;
    return {std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
}

void need_output(const std::filesystem::path& output, const std::string& command) {
    if (output.empty())
        throw InputError("F100", "", "--output is required; \"enfilade " + command + " --help\" shows how.");
}

int list_layers(const std::filesystem::path& file, const Console& console) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw IoError(file.string() + " cannot be opened.");
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    const plans::Drawing drawing = plans::read_drawing(bytes, file.string());
    if (console.json()) {
        nlohmann::ordered_json json = {{"command", "list-layers"}, {"input", file.string()}};
        json["unit"] = nullptr;
        if (drawing.declared_unit) json["unit"] = plans::name_of(*drawing.declared_unit);
        json["bounds"] = drawing.bounds;
        json["layers"] = nlohmann::ordered_json::array();
        for (const plans::Layer& layer : drawing.layers)
            json["layers"].push_back({{"name", layer.name},
                                      {"visible", layer.visible},
                                      {"shapes", layer.shape_count},
                                      {"texts", layer.text_count}});
        console.print(dump(json));
        return exit_ok;
    }
    std::size_t width = 5;
    for (const plans::Layer& layer : drawing.layers) width = std::max(width, layer.name.size());
    const auto row = [&](std::string name, const std::string& shapes, const std::string& texts, const char* note) {
        name.resize(std::max(width, name.size()), ' ');
        return name + std::string(10 - std::min<std::size_t>(9, shapes.size()), ' ') + shapes +
               std::string(8 - std::min<std::size_t>(7, texts.size()), ' ') + texts + note + '\n';
    };
    std::string text = row("Layer", "shapes", "texts", "");
    for (const plans::Layer& layer : drawing.layers)
        text += row(layer.name, std::to_string(layer.shape_count), std::to_string(layer.text_count),
                    layer.visible ? "" : "  (off)");
    console.print(text);
    return exit_ok;
}

}  // namespace enfilade::tools
