#include "tools/report_page.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "tools/console.h"
#include "tools/report/embedded.h"
#include "tools/report/finding_list.h"
#include "tools/report/html_text.h"
#include "tools/report/page_header.h"
#include "tools/report/room_graph.h"
#include "tools/report/scale_bar.h"
#include "tools/report/storey_drawing.h"
#include "tools/version.h"

namespace enfilade::tools {
namespace {

struct LayerName {
    const char* id;
    const char* title;
    bool on;
};
constexpr LayerName layer_names[] = {{"rooms", "Rooms", true},
                                     {"names", "Names, areas", true},
                                     {"walls", "Walls, columns", true},
                                     {"doors", "Doors", true},
                                     {"windows", "Windows", true},
                                     {"stairs", "Stairs, shafts", true},
                                     {"furniture", "Furniture", true},
                                     {"cells", "Convex cells", false},
                                     {"portals", "Portals", false},
                                     {"cuts", "Cuts by area", false},
                                     {"graph", "Cell graph", false},
                                     {"grid", "Grid", true},
                                     {"pins", "Pins", true}};

bool is_of_cells(const LayerName& layer) {
    const std::string_view id = layer.id;
    return id == "cells" || id == "portals" || id == "cuts" || id == "graph";
}

std::string title_of(const modeler::StoreyInfo& storey) {
    return escaped(storey.name.empty() ? storey.id : storey.name);
}

/// A line of a legend.
std::string key(const char* classes, const char* title) {
    return std::string("<span><span class=\"key ") + classes + "\"></span>" + title + "</span> ";
}

/// The colours of cuts, as a line of swatches over their areas.
std::string area_legend() {
    std::string text = "<p class=\"areas\">Cuts by area, m²</p><div class=\"areas\">";
    for (std::size_t k = 0; k < area_classes.size(); ++k)
        text += "<span class=\"a" + std::to_string(k) + "\" title=\"" + area_class_text(k) + " m²\">" +
                (k == 0 ? "" : decimal(area_classes[k], area_classes[k] < 1 ? 1 : 0)) + "</span>";
    return text + "</div>";
}

/// A bar of a round length, a fifth of the drawing wide at most; the script redraws it as the view changes.
std::string scale_bar(const DrawnBox& box) {
    const double metres = round_length(box.width / 5);
    const double size = box.width / 60;
    return "<g class=\"scalebar\" transform=\"translate(" + decimal(box.x + size, 2) + " " +
           decimal(box.y + box.height - size, 2) + ")\"><path d=\"M0 " + decimal(-size / 2, 3) + "V0H" +
           decimal(metres, 3) + "V" + decimal(-size / 2, 3) + "\"/><text x=\"" + decimal(metres + size / 2, 3) +
           "\" y=\"0\" style=\"--size:" + decimal(size, 3) + "px\">" + length_text(metres) + "</text></g>\n";
}

std::string svg_open(const char* classes, const std::string& id, const std::string& label, const DrawnBox& box) {
    const std::string view =
        decimal(box.x, 3) + " " + decimal(box.y, 3) + " " + decimal(box.width, 3) + " " + decimal(box.height, 3);
    return std::string("<div class=\"frame\"><svg class=\"drawing ") + classes + "\" id=\"" + id + "\" viewBox=\"" +
           view + "\" data-box=\"" + view + "\" style=\"--k:" + decimal(std::max(box.width, box.height) / 900, 4) +
           "\" tabindex=\"0\" role=\"group\" aria-label=\"" + label +
           ". Arrow keys move, plus and minus zoom, 0 shows all.\">\n";
}

class PageWriter {
public:
    PageWriter(const ReportSubject& subject, const modeler::CheckReport& report, const modeler::Building* building,
               const PageOptions& options)
        : subject_(subject), report_(report), building_(building), options_(options) {
        if (!building) return;
        try {
            view_.emplace(*building);
            passages_ = find_passages(*view_);
            collect_cells();
        } catch (const InputError& error) {
            view_.reset();
            trouble_ = error.what();
        }
    }

    std::string run() {
        findings_ = place_findings(report_, view());
        std::string page = head();
        page += page_header(subject_, report_, building_, view());
        page += "<main>\n" + workspace() + graph_section() + code_section() + "</main>\n";
        page += "<footer>Written by enfilade " + std::string(version) + ". Lengths in metres.</footer>\n";
        page += "<script type=\"application/json\" id=\"data\">" + script_json(page_data(findings_, view())) +
                "</script>\n<script>" + std::string(embedded::page_script) + "</script>\n</body>\n</html>\n";
        return page;
    }

private:
    [[nodiscard]] const PlanView* view() const { return view_ ? &*view_ : nullptr; }

    void collect_cells() {
        std::size_t bytes = 0;
        for (std::uint32_t k = 0; k < view_->storey_count() && bytes <= options_.cell_bytes; ++k) {
            cells_.push_back(cell_paths(cell_plan(*view_, k)));
            bytes += cells_.back().size();
        }
        if (bytes <= options_.cell_bytes) return;
        cells_.clear();
        cells_left_out_ = true;
    }

    [[nodiscard]] std::string head() const {
        std::string name = building_ && !building_->name.empty() ? building_->name : subject_.input;
        return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
               "script-src 'unsafe-inline'; img-src data:\">\n"
               "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" +
               escaped(name) + ": " + verdict_text(subject_, report_) + "</title>\n<style>\n" +
               std::string(embedded::page_style) + area_style() + "</style>\n</head>\n<body>\n";
    }

    [[nodiscard]] std::string tabs(const char* what) const {
        if (!view_ || view_->storey_count() < 2) return "";
        std::string text = "<div class=\"tabs\" role=\"tablist\" aria-label=\"Storeys\">";
        for (std::uint32_t k = 0; k < view_->storey_count(); ++k) {
            std::size_t here = 0;
            for (const PlacedFinding& finding : findings_)
                here += finding.storey == k && finding.finding->severity == Severity::Error;
            text += "<button type=\"button\" role=\"tab\" data-storey=\"" + std::to_string(k) + "\" aria-controls=\"" +
                    what + "-" + std::to_string(k) + "\"><bdi>" + title_of(building_->storeys[k]) + "</bdi>";
            if (here > 0) text += "<span class=\"dot\" title=\"" + counted(here, "error") + "\"></span>";
            text += "</button>";
        }
        return text + "</div>\n";
    }

    [[nodiscard]] std::string layer_menu() const {
        std::string text = "<details class=\"layers\"><summary>Layers</summary><div>";
        for (const LayerName& layer : layer_names) {
            if (is_of_cells(layer) && cells_left_out_) continue;
            text += std::string("<label><input type=\"checkbox\" data-layer=\"") + layer.id + "\"" +
                    (layer.on ? " checked" : "") + "><span class=\"swatch s-" + layer.id + "\"></span>" + layer.title +
                    "</label>";
        }
        if (cells_left_out_) text += "<p>Cells and portals are left out: there are too many to draw.</p>";
        else
            text += "<p class=\"legend\">" + key("clear", "clear") + key("border", "open border") +
                    key("glass", "glass") + key("shut", "shut door") + "</p>" + area_legend();
        return text + "</div></details>\n";
    }

    static std::string zoom_buttons() {
        return "<div class=\"zoom\" role=\"group\" aria-label=\"Zoom\"><button type=\"button\" data-zoom=\"in\" "
               "aria-label=\"Zoom in\">+</button><button type=\"button\" data-zoom=\"out\" aria-label=\"Zoom "
               "out\">&minus;</button><button type=\"button\" data-zoom=\"fit\">Fit</button></div>\n";
    }

    [[nodiscard]] std::string stage() const {
        if (!view_) {
            const std::string why = !building_ ? "The scene holds no model, so there is nothing to draw." : trouble_;
            return "<div class=\"stage empty\"><p>" + escaped(why) + "</p></div>\n";
        }
        const std::set<std::string> blamed = blamed_elements(report_);
        const DrawnBox box = drawn_box(*view_);
        std::string text = "<div class=\"stage\" data-view=\"plan\">\n<div class=\"bar\">" + tabs("plan") +
                           layer_menu() + zoom_buttons() + "</div>\n<div class=\"sheets\">\n";
        for (std::uint32_t k = 0; k < view_->storey_count(); ++k) {
            const std::string number = std::to_string(k), title = title_of(building_->storeys[k]);
            text += "<figure class=\"sheet\" data-storey=\"" + number + "\"><figcaption><bdi>" + title +
                    "</bdi></figcaption>\n" + svg_open("plan", "plan-" + number, "Plan of " + title, box) +
                    storey_drawing(*view_, passages_, k, cells_.empty() ? nullptr : &cells_[k], blamed) +
                    "<g class=\"layer layer-pins\">\n" + pins(findings_, k) + "</g>\n" + scale_bar(box) +
                    "</svg></div></figure>\n";
        }
        return text + "</div>\n<p class=\"status\" aria-hidden=\"true\">Drag to move, scroll to zoom.</p></div>\n";
    }

    [[nodiscard]] std::string panel() const {
        std::string text =
            "<aside class=\"panel\" aria-label=\"Findings\">\n<div class=\"filters\">"
            "<label class=\"search\">Search findings<input type=\"search\" id=\"search\" "
            "autocomplete=\"off\"></label>\n"
            "<div class=\"row\">";
        for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Note}) {
            std::size_t count = 0;
            for (const Finding& finding : report_.findings) count += finding.severity == severity;
            const std::string name = name_of(severity);
            text += "<label class=\"sevbox " + name + "\"><input type=\"checkbox\" data-severity=\"" + name +
                    "\" checked" + (count == 0 ? " disabled" : "") + "><span>" + counted(count, name) +
                    "</span></label>";
        }
        text +=
            "</div>\n<div class=\"row\"><select id=\"code\" aria-label=\"Code\"><option value=\"\">All "
            "codes</option>";
        std::set<std::string> codes;
        for (const Finding& finding : report_.findings) codes.insert(finding.code);
        for (const std::string& code : codes)
            text += "<option value=\"" + escaped(code) + "\">" + escaped(code) + "</option>";
        text +=
            "</select><select id=\"sort\" aria-label=\"Sort\"><option value=\"n\">By severity</option><option "
            "value=\"code\">By code</option><option value=\"storey\">By storey</option></select></div>\n"
            "<p class=\"shown\" id=\"shown\" role=\"status\"></p></div>\n<ol class=\"findings\" id=\"findings\">\n";
        text += finding_list(findings_, view());
        if (findings_.empty()) text += "<li class=\"none\">Nothing was found.</li>\n";
        return text + "</ol></aside>\n";
    }

    [[nodiscard]] std::string workspace() const {
        return "<section class=\"workspace\" aria-label=\"Plans and findings\">\n" + stage() + panel() + "</section>\n";
    }

    [[nodiscard]] std::string graph_section() const {
        if (!view_) return "";
        const DrawnBox plan = drawn_box(*view_);
        const DrawnBox box = {plan.x - 0.4, plan.y - 0.4, plan.width + 0.8, plan.height + 0.8};
        std::string text =
            "<section class=\"graphs\" aria-labelledby=\"graph-title\">\n<h2 id=\"graph-title\">Rooms and what joins "
            "them</h2>\n<p class=\"lead\">Each number says how many doors, openings and open borders lie between a "
            "room and the outside.</p>\n<div class=\"stage\" data-view=\"graph\"><div class=\"bar\">" +
            tabs("graph") + zoom_buttons() + "</div>\n<div class=\"sheets\">\n";
        for (std::uint32_t k = 0; k < view_->storey_count(); ++k) {
            const std::string number = std::to_string(k), title = title_of(building_->storeys[k]);
            text += "<figure class=\"sheet\" data-storey=\"" + number + "\"><figcaption><bdi>" + title +
                    "</bdi>: " + room_graph_caption(*view_, passages_, k) + "</figcaption>\n" +
                    svg_open("graph", "graph-" + number, "Graph of " + title, box) + room_graph(*view_, passages_, k) +
                    "</svg></div></figure>\n";
        }
        return text + "</div></div>\n<p class=\"legend\">" + key("g-door", "door") + key("g-opening", "opening") +
               key("g-border", "open border") + key("g-low", "over a low wall") + key("g-stair", "stair or shaft") +
               "</p></section>\n";
    }

    [[nodiscard]] std::string code_section() const {
        const std::string rows = code_table(report_);
        if (rows.empty()) return "";
        return "<section class=\"codes\" aria-labelledby=\"codes-title\">\n<h2 id=\"codes-title\">What was "
               "checked</h2>\n<table><thead><tr><th scope=\"col\">Code</th><th scope=\"col\">Meaning</th><th "
               "scope=\"col\" class=\"number\">Findings</th></tr></thead><tbody>\n" +
               rows + "</tbody></table></section>\n";
    }

    const ReportSubject& subject_;
    const modeler::CheckReport& report_;
    const modeler::Building* building_;
    const PageOptions& options_;
    std::optional<PlanView> view_;
    Passages passages_;
    std::vector<CellPaths> cells_;  ///< [storey], empty where left out
    bool cells_left_out_ = false;
    std::string trouble_;  ///< why nothing is drawn
    std::vector<PlacedFinding> findings_;
};

}  // namespace

std::string report_page(const ReportSubject& subject, const modeler::CheckReport& report,
                        const modeler::Building* building, const PageOptions& options) {
    return PageWriter(subject, report, building, options).run();
}

}  // namespace enfilade::tools
