#pragma once
// What a benchmark writes: sections with tables, and at the end which goals are met.

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/error.h"
#include "tools/gpu/markdown.h"

namespace enfilade::tools::gpu {

/// "not measured" where nothing was.
[[nodiscard]] inline std::string measured(std::optional<double> value, const std::string& unit = "") {
    return value ? three_digits(*value) + unit : "not measured";
}

/// A figure that an aim of the project names.
struct GoalRow {
    std::string what;
    double least;                 ///< the ratio that it shall reach
    std::optional<double> ratio;  ///< nothing: not measured
    std::string of;               ///< who against whom
};

/// Writes as it goes, so that what was measured before a fault is not lost.
class Report {
public:
    Report(std::ostream& out, std::ostream& log) : out_(&out), log_(&log) {}

    void section(const std::string& title, const std::string& sentence);
    void table(const MarkdownTable& table);
    void sentence(const std::string& text);
    void progress(const std::string& text) { *log_ << text << std::endl; }
    /// Does what may fail for want of memory, say; if it does, the report says so and goes on.
    template <class Work>
    void guarded(const std::string& what, const Work& work) {
        try {
            work();
        } catch (const IoError& error) {
            failed_.push_back(what + " (" + error.what() + ")");
            progress(what + " failed: " + error.what());
        }
    }
    [[nodiscard]] bool has_failed() const { return !failed_.empty(); }
    /// Says at the end what nobody had time for.
    void leave_out(const std::string& what) { left_out_.push_back(what); }
    void add_goal(GoalRow goal) { goals_.push_back(std::move(goal)); }
    /// The section of the goals, what was left out, and what failed.
    void write_goals();

private:
    std::ostream* out_;
    std::ostream* log_;
    std::vector<GoalRow> goals_;
    std::vector<std::string> left_out_, failed_;
};

}  // namespace enfilade::tools::gpu
