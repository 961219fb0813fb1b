#include <algorithm>
#include <cmath>
#include <map>
#include <pugixml.hpp>

#include "base/error.h"
#include "modeler/catalogue/source_index.h"
#include "plans/sweet_home/xml.h"

namespace enfilade::modeler {
namespace {

constexpr double metres = 0.01;  ///< homes write centimetres

std::string text_of(const pugi::xml_node& node, const char* key) { return node.attribute(key).as_string(); }

bool is_turned(const pugi::xml_node& node) {
    const std::string rotation = text_of(node, "modelRotation");
    return (!rotation.empty() && rotation != "1 0 0 0 1 0 0 0 1" &&
            rotation != "1.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0") ||
           node.attribute("modelTransformations") || node.child("transformation");
}

std::optional<std::array<double, 3>> size_of(const pugi::xml_node& node) {
    std::array<double, 3> size;
    const char* keys[] = {"width", "depth", "height"};
    for (std::size_t k = 0; k < 3; ++k) {
        size[k] = node.attribute(keys[k]).as_double() * metres;
        if (!(size[k] > 0 && size[k] < 1e3)) return std::nullopt;
    }
    return size;
}

class Pieces {
public:
    Pieces(const std::string& title, SourceIndex& index) : home_(stem_of_name(title)), index_(index) {}

    void visit(const pugi::xml_node& parent) {
        for (const pugi::xml_node node : parent.children()) {
            const std::string_view kind = node.name();
            if (kind == "furnitureGroup") visit(node);  // its reader limits how deep elements lie
            else if (kind == "pieceOfFurniture" || kind == "light" || kind == "shelfUnit") add(node);
        }
    }

private:
    /// The first piece of a model that stands as its model does says how large that is.
    void add(const pugi::xml_node& node) {
        const std::string model = text_of(node, "model");
        if (model.empty()) return;
        const auto [at, is_new] = known_.emplace(model, index_.records.size());
        if (is_new) {
            CatalogueRecord record;
            record.model = record.alias = model;
            record.entry.id = home_ + "/" + model;
            record.fitting.unit = metres;
            record.cleared = false;
            index_.records.push_back(std::move(record));
        }
        CatalogueRecord& record = index_.records[at->second];
        const bool stands = !is_turned(node);
        if (!is_new && (record.fitting.size || !stands)) return;
        record.entry.name = text_of(node, "name");
        if (record.entry.name.empty()) record.entry.name = stem_of_name(model);
        record.entry.creator = text_of(node, "creator");
        record.entry.elevation = std::clamp(node.attribute("elevation").as_double() * metres, 0.0, 1e3);
        if (!stands) return;
        record.fitting.size = size_of(node);
        record.cleared = record.fitting.size && !node.attribute("staircaseCutOutShape");
        const double share = node.attribute("dropOnTopElevation").as_double(1);  // of its height
        if (record.fitting.size && node.attribute("dropOnTopElevation") && share > 0 && share <= 1)
            record.entry.top = share * (*record.fitting.size)[2];
    }

    std::string home_;
    SourceIndex& index_;
    std::map<std::string, std::size_t> known_;
};

}  // namespace

void list_home(const FileTree& files, const std::string& title, SourceIndex& index) {
    const auto text = files.read("Home.xml");
    if (!text)
        throw InputError(
            "K104", title,
            "The archive holds no Home.xml; open the home with Sweet Home 3D 5.3 or later and save it again.");
    pugi::xml_document document;
    plans::parse_home_xml(document, *text, title);
    Pieces(title, index).visit(document.document_element());
}

}  // namespace enfilade::modeler
