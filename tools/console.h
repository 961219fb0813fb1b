#pragma once
// What a command says and where: results to stdout, everything else to stderr.

#include <string>
#include <string_view>
#include <vector>

namespace enfilade::tools {

class Console {
public:
    Console() = default;
    Console(bool quiet, bool json) : quiet_(quiet), json_(json) {}

    [[nodiscard]] bool quiet() const { return quiet_; }
    [[nodiscard]] bool json() const { return json_; }

    /// A line for a person, or several: kept back by --quiet and by --json.
    void say(std::string_view line) const;
    /// The result that the user asked for, whatever the flags: its own line end included.
    void print(std::string_view text) const;
    /// A line on stderr, whatever the flags.
    void warn(std::string_view line) const;
    /// True where a bar may be drawn: stderr is a terminal and nobody asked for quiet.
    [[nodiscard]] bool shows_progress() const;

private:
    bool quiet_ = false;
    bool json_ = false;
};

/// "1,234,567"
[[nodiscard]] std::string grouped(unsigned long long value);
/// "3 walls", "1 wall"; `many` where the plural is irregular.
[[nodiscard]] std::string counted(unsigned long long value, std::string_view one, std::string_view many = {});
/// "812 B", "1.4 MB"
[[nodiscard]] std::string byte_text(double bytes);
/// "43 ms", "1.20 s"
[[nodiscard]] std::string time_text(double seconds);

}  // namespace enfilade::tools
