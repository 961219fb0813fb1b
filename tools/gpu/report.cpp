#include "tools/gpu/report.h"

namespace enfilade::tools::gpu {

namespace {

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
    return text;
}

}  // namespace

void Report::section(const std::string& title, const std::string& sentence) {
    *out_ << "## " << title << "\n\n" << sentence << "\n\n" << std::flush;
}

void Report::table(const MarkdownTable& table) {
    if (!table.is_empty()) *out_ << table.text() << "\n" << std::flush;
}

void Report::sentence(const std::string& text) { *out_ << text << "\n\n" << std::flush; }

void Report::write_goals() {
    section("Goals", "Ratios of rays a second on the same card in the same run.");
    MarkdownTable rows({"what", "goal", "ratio", "between", "verdict"});
    for (const GoalRow& goal : goals_)
        rows.add({goal.what, three_digits(goal.least) + " or more", measured(goal.ratio), goal.of,
                  !goal.ratio                 ? "not measured"
                  : *goal.ratio >= goal.least ? "met"
                                              : "not met"});
    table(rows);
    if (!left_out_.empty()) sentence("Left out, because the time was up: " + joined(left_out_) + ".");
    if (!failed_.empty()) sentence("Failed: " + joined(failed_) + ".");
}

}  // namespace enfilade::tools::gpu
