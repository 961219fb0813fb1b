#include "tools/gpu/command_line.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <memory>

#include "base/error.h"
#include "render/cuda/device.h"
#include "render/executor.h"
#include "tools/gpu/bench.h"
#include "tools/gpu/check_frames.h"
#include "tools/gpu/check_meshes.h"
#include "tools/gpu/check_streams.h"
#include "tools/gpu/markdown.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

namespace {

constexpr const char* usage =
    "enfilade_gpu: whether a CUDA card's pictures and rays are those of the scalar tracer, and how fast it is.\n"
    "\n"
    "  enfilade_gpu card                  says which card there is\n"
    "  enfilade_gpu check SCENE.enf ...   compares every variant with the scalar tracer\n"
    "  enfilade_gpu bench SCENE.enf ...   measures every variant and what it is compared with\n"
    "\n"
    "  --on card|host   where kernels run: a card, or this machine's cores, which run the same functions (card)\n"
    "  --device N       which card, counted from 0 (0)\n"
    "  --side N         pixels a side of compared pictures (1024; on the host 64)\n"
    "  --views N        views of each scene that are compared, at most (2)\n"
    "  --quick          bench: fewer rounds and smaller batches, for a first look\n"
    "  --rays N         rays of a batch (check: 2 million, on the host 4,096; bench: 64 million, fewer where the\n"
    "                   card's memory is small)\n"
    "  --minutes N      bench: what is not measured by then is left out (5)\n"
    "  --help           says this\n"
    "\n"
    "Reports go to standard output as Markdown, progress to standard error. Ends with 0 when all is well, 1 when\n"
    "answers are wrong, 2 when a file or an argument is, 3 when a file or the card would not do its part.\n";

struct Arguments {
    std::string command;
    std::vector<std::filesystem::path> scenes;
    bool on_host = false;
    int device = 0;
    int side = 0;  ///< 0: what suits the device
    int views = 2;
    bool is_quick = false;
    int rays = 0;  ///< 0: what suits the device
    int minutes = 5;
};

[[noreturn]] void refuse(const std::string& sentence) {
    throw InputError("", "", sentence + " See enfilade_gpu --help.");
}

int number(const std::string& flag, const std::string& text, int least, int most) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
        refuse(flag + " takes a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
               ", not \"" + text + "\".");
    return value;
}

Arguments parsed(const std::vector<std::string>& words) {
    Arguments arguments;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const auto value = [&]() -> const std::string& {
            if (i + 1 == words.size()) refuse(word + " stands without its value.");
            return words[++i];
        };
        if (word == "--on") {
            const std::string& where = value();
            if (where != "host" && where != "card") refuse("--on takes card or host, not \"" + where + "\".");
            arguments.on_host = where == "host";
        } else if (word == "--device") {
            arguments.device = number(word, value(), 0, 1023);
        } else if (word == "--side") {
            arguments.side = number(word, value(), 1, 16384);
        } else if (word == "--views") {
            arguments.views = number(word, value(), 1, 10000);
        } else if (word == "--rays") {
            arguments.rays = number(word, value(), 32, 1 << 30);
        } else if (word == "--minutes") {
            arguments.minutes = number(word, value(), 1, 10000);
        } else if (word == "--quick") {
            arguments.is_quick = true;
        } else if (word.starts_with("-")) {
            refuse("There is no " + word + ".");
        } else if (arguments.command.empty()) {
            arguments.command = word;
        } else {
            arguments.scenes.emplace_back(word);
        }
    }
    if ((arguments.command == "check" || arguments.command == "bench") && arguments.scenes.empty())
        refuse("Name the scenes.");
    return arguments;
}

std::unique_ptr<render::cuda::Device> opened(const Arguments& arguments, const accel::Executor& executor) {
    return arguments.on_host ? render::cuda::open_host(executor) : render::cuda::open_card(arguments.device);
}

int run_card(const Arguments& arguments, std::ostream& out) {
    if (const std::string why = render::cuda::why_no_card(arguments.device); !why.empty())
        throw render::cuda::CudaError(why);
    for (const render::cuda::Card& card : render::cuda::cards()) {
        if (card.number != arguments.device) continue;
        out << card.name << ", compute capability " << card.major << "." << card.minor << ", " << card.multiprocessors
            << " multiprocessors, " << bytes_text(card.memory_bytes) << ", L2 " << bytes_text(card.l2_bytes)
            << ", driver for CUDA " << card.driver_version / 1000 << "." << card.driver_version % 1000 / 10 << "\n";
    }
    return 0;
}

/// Those that can be read; what is wrong with the others goes to `log`. \throws InputError where none is left
std::vector<TriedScene> opened_scenes(const Arguments& arguments, std::ostream& log) {
    std::vector<TriedScene> scenes;
    for (const std::filesystem::path& file : arguments.scenes) {
        try {
            scenes.push_back(open_tried_scene(file));
        } catch (const InputError& error) {
            log << "left out: " << error.located() << std::endl;
        } catch (const IoError& error) {
            log << "left out: " << error.what() << std::endl;
        }
    }
    if (scenes.empty()) refuse("None of these scenes can be read.");
    return scenes;
}

int run_check(const Arguments& arguments, std::ostream& out, std::ostream& log) {
    const std::unique_ptr<accel::Executor> executor = render::make_executor();
    const std::unique_ptr<render::cuda::Device> device = opened(arguments, *executor);
    CheckOptions options;
    options.side = arguments.side != 0 ? arguments.side : device->is_card() ? 1024 : 64;
    options.views = static_cast<std::size_t>(arguments.views);

    if (!device->is_card()) options.rays = 1 << 12;
    if (arguments.rays != 0) options.rays = static_cast<std::size_t>(arguments.rays);
    MarkdownTable table({"scene", "what", "by", "asked", "the same", "at edges", "leaks", "largest error of a distance",
                         "same means", "verdict"});
    std::vector<std::string> faults;
    for (const TriedScene& scene : opened_scenes(arguments, log)) {
        log << "checking " << scene.name << std::endl;
        std::vector<Agreement> rows;
        const auto add = [&](std::vector<Agreement> more) {
            rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
        };
        if (scene.is_single_mesh()) {
            add(check_meshes(*device, scene, options, *executor));
        } else {
            add(check_frames(*device, scene, options, *executor));
            add(check_streams(*device, scene, options, *executor));
        }
        for (const Agreement& row : rows) {
            table.add({row.scene, row.what, row.way, grouped(row.asked), share_text(row.same, row.asked),
                       grouped(row.explained), grouped(row.leaks),
                       row.distance_error > 0 ? three_digits(1e6 * row.distance_error) + " um" : "0", row.bound,
                       row.is_right ? "right" : "WRONG"});
            if (!row.is_right) faults.push_back(row.scene + ", " + row.what + ", " + row.way + ": " + row.fault);
        }
    }
    out << "## Agreement with the scalar tracer, on " << device->name() << "\n\n" << table.text() << "\n";
    for (const std::string& fault : faults) out << "- " << fault << "\n";
    out << (faults.empty() ? "All answers are right.\n" : "Some answers are wrong.\n");
    return faults.empty() ? 0 : 1;
}

BenchOptions bench_options(const Arguments& arguments, const render::cuda::Device& device) {
    BenchOptions options;
    if (!device.is_card()) {
        options.rounds = 1;
        options.side = options.large_side = 16;
        options.rays = 256;
    } else {
        for (const render::cuda::Card& card : render::cuda::cards()) {
            if (card.number != arguments.device) continue;
            options.rays = std::min(options.rays, card.memory_bytes / 256);      // with answers, and room to sort
            if (card.memory_bytes < 40'000'000'000u) options.large_side = 4096;  // of all competitors at once
        }
    }
    if (arguments.is_quick && device.is_card()) {
        options.rounds = 3;
        options.rays = std::min<std::size_t>(options.rays, 8u << 20);
        options.large_side = 4096;
    }
    if (arguments.side != 0) options.side = arguments.side;
    if (arguments.rays != 0) options.rays = static_cast<std::size_t>(arguments.rays);
    options.end = std::chrono::steady_clock::now() + std::chrono::minutes(arguments.minutes);
    return options;
}

int run_bench(const Arguments& arguments, std::ostream& out, std::ostream& log) {
    const std::unique_ptr<accel::Executor> executor = render::make_executor();
    const std::unique_ptr<render::cuda::Device> device = opened(arguments, *executor);
    const BenchOptions options = bench_options(arguments, *device);
    const std::vector<TriedScene> scenes = opened_scenes(arguments, log);
    out << "# Measured on " << device->name() << "\n\n";
    if (device->is_card()) run_card(arguments, out);
    else out << "These cores are no card: everything was run once, and nothing was measured.\n";
    out << "\n";
    Report report(out, log);
    const Limits limits = bench_limits(*device, options, report);
    bench_frames(*device, scenes, limits, options, *executor, report);
    bench_batches(*device, scenes, limits, options, *executor, report);
    bench_meshes(*device, scenes, options, *executor, report);
    report.write_goals();
    return report.has_failed() ? 3 : 0;
}

}  // namespace

int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& log) {
    for (const std::string& word : words) {
        if (word != "--help" && word != "-h") continue;
        out << usage;
        return 0;
    }
    const Arguments arguments = parsed(words);
    if (arguments.command == "card") return run_card(arguments, out);
    if (arguments.command == "check") return run_check(arguments, out, log);
    if (arguments.command == "bench") return run_bench(arguments, out, log);
    if (arguments.command.empty()) refuse("Say what to do: card, check or bench.");
    refuse("There is no command \"" + arguments.command + "\".");
}

}  // namespace enfilade::tools::gpu
