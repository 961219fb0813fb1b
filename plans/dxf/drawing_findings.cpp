#include "plans/dxf/drawing_findings.h"

#include <algorithm>

#include "plans/dxf/words.h"

namespace enfilade::plans::dxf {
namespace {

void merge(Tally& into, const Tally& more) {
    if (more.count == 0) return;
    into.first_line = into.count == 0 ? more.first_line : std::min(into.first_line, more.first_line);
    into.count += more.count;
}

void merge(LeftOut& into, const LeftOut& more) {
    for (const auto& [kind, tally] : more.unknown_kinds) merge(into.unknown_kinds[kind], tally);
    merge(into.paper_space, more.paper_space);
    merge(into.invisible, more.invisible);
    merge(into.broken, more.broken);
    merge(into.meshes, more.meshes);
    merge(into.cut_texts, more.cut_texts);
}

std::string entities(const Tally& tally) {
    return std::to_string(tally.count) + (tally.count == 1 ? " entity" : " entities");
}

std::string first_at(const Tally& tally) { return "the first one at line " + std::to_string(tally.first_line); }

std::string unknown_kinds(const std::map<std::string, Tally>& kinds) {
    std::string list;
    for (const auto& [kind, tally] : kinds)
        list += (list.empty() ? "" : ", ") + std::to_string(tally.count) + " " + kind;
    return list;
}

}  // namespace

void add_findings(Drawing& drawing, const Contents& contents, const BlockUse& use, const FlatShapes& shapes) {
    LeftOut all;
    for (const auto& [key, part] : contents.left_out) {
        const auto block = contents.block_index.find(key);
        const bool used = key.empty() || (block != contents.block_index.end() && use.used[block->second]);
        if (used) merge(all, part);
    }
    merge(all.broken, shapes.broken);
    const auto say = [&](const char* code, Severity severity, std::string sentence, std::string hint) {
        Finding finding;
        finding.code = code;
        finding.severity = severity;
        finding.sentence = std::move(sentence);
        finding.hint = std::move(hint);
        drawing.findings.push_back(std::move(finding));
    };
    if (all.broken.count > 0)
        say("P712", Severity::Error,
            entities(all.broken) + " without usable numbers or without extent left out, " + first_at(all.broken) + ".",
            "Draw it again, or delete it.");
    if (all.paper_space.count > 0)
        say("P713", Severity::Note, entities(all.paper_space) + " of paper space (title blocks, views) left out.", "");
    if (shapes.raised.count > 0)
        say("P714", Severity::Note,
            entities(shapes.raised) + " above or below height 0 seen from above, " + first_at(shapes.raised) + ".", "");
    if (!all.unknown_kinds.empty())
        say("P715", Severity::Note, "Entities that make no lines left out: " + unknown_kinds(all.unknown_kinds) + ".",
            "");
    if (all.meshes.count > 0)
        say("P715", Severity::Note,
            "Meshes in space (POLYLINE) left out: " + std::to_string(all.meshes.count) + ", " + first_at(all.meshes) +
                ".",
            "");
    if (all.invisible.count > 0) say("P716", Severity::Note, entities(all.invisible) + " set invisible left out.", "");
    for (const auto& [name, tally] : use.missing)
        say("P717", Severity::Warning,
            "The block \"" + shortened(name) + "\" is not in the file; its insertions are left out: " +
                std::to_string(tally.count) + ", " + first_at(tally) + ".",
            "Bind external references before saving the drawing as DXF.");
    if (all.cut_texts.count > 0)
        say("P718", Severity::Note,
            "Texts longer than 1000 bytes cut: " + std::to_string(all.cut_texts.count) + ", " +
                first_at(all.cut_texts) + ".",
            "");
    if (contents.unit_code != 0 && !contents.unit)
        say("P709", Severity::Warning,
            "The drawing's unit ($INSUNITS " + std::to_string(contents.unit_code) +
                ") is none that buildings are drawn in; it is passed over.",
            "Give the unit.");
    if (!contents.code_page.empty())
        say("P719", Severity::Warning,
            "The code page \"" + shortened(contents.code_page, 40) + "\" is not known; texts are read as ANSI_1252.",
            "Save the drawing in a newer DXF version (2007 or later), whose texts are UTF-8.");
}

}  // namespace enfilade::plans::dxf
