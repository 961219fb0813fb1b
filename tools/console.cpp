#include "tools/console.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "base/error.h"

namespace enfilade::tools {

namespace {
void put(std::FILE* stream, std::string_view text, bool end_line) {
    std::fwrite(text.data(), 1, text.size(), stream);
    if (end_line) std::fputc('\n', stream);
}

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}
}  // namespace

void Console::say(std::string_view line) const {
    if (!quiet_ && !json_) put(stdout, line, !line.ends_with('\n'));
}

void Console::print(std::string_view text) const {
    put(stdout, text, false);
    if (std::fflush(stdout) != 0)
        throw IoError("The output cannot be written: the disk is full, or its reader is gone.");
}

void Console::warn(std::string_view line) const { put(stderr, line, true); }

bool Console::shows_progress() const {
    const char* terminal = std::getenv("TERM");
    return !quiet_ && isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::string grouped(unsigned long long value) {
    std::string digits = std::to_string(value);
    for (std::size_t place = digits.size(); place > 3; place -= 3) digits.insert(place - 3, 1, ',');
    return digits;
}

std::string counted(unsigned long long value, std::string_view one, std::string_view many) {
    std::string text = grouped(value) + ' ';
    if (value == 1) return text.append(one);
    if (!many.empty()) return text.append(many);
    return text.append(one) + 's';
}

std::string byte_text(double bytes) {
    if (bytes < 1e3) return formatted("%.0f B", bytes);
    if (bytes < 1e6) return formatted("%.1f kB", bytes / 1e3);
    if (bytes < 1e9) return formatted("%.1f MB", bytes / 1e6);
    return formatted("%.2f GB", bytes / 1e9);
}

std::string time_text(double seconds) {
    if (seconds < 1e-3) return formatted("%.0f us", seconds * 1e6);
    if (seconds < 0.1) return formatted("%.1f ms", seconds * 1e3);
    if (seconds < 1) return formatted("%.0f ms", seconds * 1e3);
    if (seconds < 100) return formatted("%.2f s", seconds);
    return formatted("%.0f s", seconds);
}

}  // namespace enfilade::tools
