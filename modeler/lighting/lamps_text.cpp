#include "modeler/lighting/lamps_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "plans/limits.h"

namespace enfilade::modeler {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void damaged(const std::string& what) {
    throw InputError("F20", "", "The scene's model is damaged: " + what + ". Build the scene again from its plan.");
}

/// What most lamps have is not written.
Json lamp_json(const Lamp& lamp) {
    const Lamp usual;
    Json json = {{"id", lamp.id}, {"position", lamp.position}, {"lumen", lamp.lumen}};
    if (!lamp.name.empty()) json["name"] = lamp.name;
    if (lamp.storey != usual.storey) json["storey"] = lamp.storey;
    if (lamp.radius != usual.radius) json["radius"] = lamp.radius;
    if (lamp.colour != usual.colour) json["colour"] = lamp.colour;
    if (!lamp.carrier.empty()) json["carrier"] = lamp.carrier;
    if (lamp.by_rule) json["by_rule"] = true;
    return json;
}

Lamp lamp_from(const Json& json, std::size_t storey_count) {
    Lamp lamp;
    lamp.id = json.at("id");
    lamp.name = json.value("name", "");
    lamp.position = json.at("position").get<std::array<double, 3>>();
    for (const double x : lamp.position)
        if (!(std::abs(x) < 1e9)) damaged("the position of a lamp beyond all bounds");
    lamp.lumen = json.at("lumen");
    lamp.radius = json.value("radius", lamp.radius);
    if (!(lamp.lumen >= 0 && lamp.lumen <= plans::limits::lumen)) damaged("a lamp of no power that there is");
    if (!(lamp.radius >= 0 && lamp.radius <= plans::limits::height)) damaged("a lamp of no size that there is");
    if (json.contains("colour")) lamp.colour = json.at("colour").get<plans::Colour>();
    for (const float share : lamp.colour)
        if (!(share >= 0 && share <= 1)) damaged("a lamp of no colour that there is");
    lamp.storey = json.value("storey", lamp.storey);
    if (lamp.storey != UINT32_MAX && lamp.storey >= storey_count) damaged("a lamp of no storey");
    lamp.carrier = json.value("carrier", "");
    lamp.by_rule = json.value("by_rule", false);
    return lamp;
}

}  // namespace

std::string lamps_text(const std::vector<Lamp>& lamps) {
    Json json = Json::array();
    for (const Lamp& lamp : lamps) json.push_back(lamp_json(lamp));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<Lamp> read_lamps(const std::string& text, std::size_t storey_count) {
    std::vector<Lamp> lamps;
    try {
        for (const Json& json : Json::parse(text)) {
            lamps.push_back(lamp_from(json, storey_count));
            if (lamps.size() > 1 && lamps[lamps.size() - 2].id >= lamps.back().id)
                damaged("its lamps are out of order");
        }
    } catch (const Json::exception& error) {
        damaged(error.what());
    }
    return lamps;
}

}  // namespace enfilade::modeler
