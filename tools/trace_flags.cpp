#include "tools/trace_flags.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace enfilade::tools {

namespace {

using render::Precision;
using render::Tracer;

constexpr int largest_packet = 256;
constexpr int least_largest_packet = 16;
constexpr int smallest_packet = 4;
constexpr float usual_mirror = 0.25f;  ///< of polished stone

/// The number that is all of `text`.
template <class T>
std::optional<T> number(std::string_view text) {
    T value = {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

bool is_power_of_two(int value) { return value > 0 && (value & (value - 1)) == 0; }

/// "64:8"
render::PacketSizes parse_packets(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto largest = number<int>(std::string_view(text).substr(0, colon));
    const auto smallest =
        colon == std::string::npos ? std::nullopt : number<int>(std::string_view(text).substr(colon + 1));
    const bool are_good = largest && smallest && is_power_of_two(*largest) && is_power_of_two(*smallest) &&
                          *largest >= least_largest_packet && *largest <= largest_packet &&
                          *smallest >= smallest_packet && *smallest <= *largest;
    if (!are_good)
        throw InputError("F130", "",
                         "--packets \"" + text +
                             "\" are no sizes: give LARGEST:SMALLEST, two powers of two like 64:8, the largest from 16 "
                             "to 256 and the smallest from 4 up to the largest.");
    return {*largest, *smallest};
}

/// A share from 0 to 1; the flag alone asks for the usual one.
float parse_mirror(const std::string& text) {
    if (text.empty()) return usual_mirror;
    const auto share = number<float>(text);
    if (!share || !(*share >= 0 && *share <= 1))
        throw InputError("F131", "",
                         "--mirror-floor \"" + text +
                             "\" is no share: give a number from 0 (dull) to 1 (a mirror), or nothing for 0.25.");
    return *share;
}

/// What --show counts, whatever makes pictures of light.
TracerChoice scalar_walk(const RenderOptions& options) {
    const bool is_usual = (options.tracer.empty() || options.tracer == "scalar") && options.real != "double" &&
                          options.packets.empty() && !options.mirror_floor && !options.stats && options.device.empty();
    if (!is_usual)
        throw InputError("F138", "",
                         "--show " + options.show +
                             " counts what the scalar tracer does in single precision, without mirrors: leave out "
                             "other tracers, --real double, --packets, --mirror-floor and --stats.");
    TracerChoice choice;
    choice.tracer = Tracer::Scalar;
    return choice;
}

/// "1", or "host".
TracerChoice::Device parse_device(const std::string& text) {
    if (text.empty()) return {};
    if (text == "host") return {.is_host = true};
    const auto card = number<int>(text);
    if (!card || *card < 0)
        throw InputError("F149", "",
                         "--device \"" + text +
                             "\" is none: give a card's number, counted from 0, or host for this machine's cores.");
    return {.card = *card};
}

Tracer parse_tracer(const std::string& name) {
    if (name == "scalar") return Tracer::Scalar;
    return name == "simd" ? Tracer::Simd : Tracer::Packet;
}

}  // namespace

const char* TracerChoice::name() const {
    if (is_oracle) return "oracle";
    if (device) return "cuda";
    if (tracer == Tracer::Scalar) return "scalar";
    return tracer == Tracer::Simd ? "simd" : "packet";
}

TracerChoice tracer_choice(const RenderOptions& options) {
    if (!options.show.empty()) return scalar_walk(options);
    TracerChoice choice;
    choice.is_oracle = options.tracer == "oracle";
    if (options.tracer == "cuda") choice.device = parse_device(options.device);
    else if (!options.device.empty())
        throw InputError("F149", "", "--device is for --tracer cuda: give that as well, or leave --device out.");
    const bool is_double = options.real == "double";
    choice.tracer = options.tracer.empty() && is_double ? Tracer::Scalar : parse_tracer(options.tracer);
    choice.precision = is_double || choice.is_oracle ? Precision::Double : Precision::Float;
    if (is_double && !choice.is_oracle && !choice.device && choice.tracer != Tracer::Scalar)
        throw InputError("F132", "",
                         "--tracer " + options.tracer +
                             " walks in single precision: give --tracer scalar with --real double, or leave --real "
                             "out.");
    if (options.real == "float" && choice.is_oracle)
        throw InputError("F132", "", "The oracle reckons in double precision: leave out --real float.");
    if (options.stats && choice.is_oracle)
        throw InputError("F133", "",
                         "The oracle walks through no cells: leave out --stats, or choose another --tracer.");
    if (options.stats && choice.device)
        throw InputError("F133", "", "A card counts nothing: leave out --stats, or choose another --tracer.");
    if (!options.packets.empty()) {
        choice.packets = parse_packets(options.packets);
        if (!choice.has_packets())
            throw InputError("F133", "",
                             std::string("--packets means nothing to --tracer ") + choice.name() +
                                 ": leave it out, or choose --tracer packet.");
    }
    if (options.mirror_floor) choice.mirror_floor = parse_mirror(*options.mirror_floor);
    return choice;
}

}  // namespace enfilade::tools
