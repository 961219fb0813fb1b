#include "accel/certificate.h"

#include <algorithm>
#include <charconv>

namespace enfilade::accel {
namespace {

/// Takes the text before the next `stop` off the front of `text`.
std::string_view take(std::string_view& text, char stop) {
    const std::size_t end = std::min(text.find(stop), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return taken;
}

std::string on_one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

}  // namespace

Sha256 model_hash(std::span<const SceneArray> arrays) {
    std::vector<std::byte> hashes;
    for (const SceneArray& array : arrays)
        if (array.group == Group::Model)
            for (const std::uint8_t byte : array.sha256) hashes.push_back(std::byte{byte});
    return sha256(hashes);
}

std::string to_text(const Certificate& certificate) {
    std::string text = "program " + on_one_line(certificate.program_version) + "\n";
    text += "options " + on_one_line(certificate.options) + "\n";
    for (const auto& [code, count] : certificate.code_counts)
        text += "code " + on_one_line(code) + " " + std::to_string(count) + "\n";
    if (!certificate.model_sha256.empty()) text += "model " + certificate.model_sha256 + "\n";
    for (const auto& [name, hash] : certificate.trace_sha256) text += "trace " + name + " " + hash + "\n";
    return text;
}

std::optional<Certificate> certificate_from_text(std::string_view text) {
    Certificate certificate;
    while (!text.empty()) {
        std::string_view line = take(text, '\n');
        const std::string_view key = take(line, ' ');
        if (key == "program") {
            certificate.program_version = line;
        } else if (key == "options") {
            certificate.options = line;
        } else if (key == "code") {
            const std::string_view code = take(line, ' ');
            std::uint64_t count = 0;
            const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
            if (error != std::errc() || end != line.data() + line.size()) return std::nullopt;
            certificate.code_counts.emplace_back(code, count);
        } else if (key == "model") {
            certificate.model_sha256 = line;
        } else if (key == "trace") {
            const std::string_view name = take(line, ' ');
            certificate.trace_sha256.emplace_back(name, line);
        }  // other keys: a later version's, not ours to judge
    }
    return certificate;
}

std::optional<Certificate> certificate(const Scene& scene) {
    for (const SceneArray& array : scene.arrays())
        if (array.group == Group::Certificate)
            return certificate_from_text({reinterpret_cast<const char*>(array.bytes.data()), array.bytes.size()});
    return std::nullopt;
}

}  // namespace enfilade::accel
