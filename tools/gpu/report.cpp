#include "tools/gpu/report.h"

namespace enfilade::tools::gpu {

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
    if (left_out_.empty()) return;
    std::string names;
    for (const std::string& what : left_out_) names += (names.empty() ? "" : "; ") + what;
    sentence("Left out, because the time was up: " + names + ".");
}

}  // namespace enfilade::tools::gpu
