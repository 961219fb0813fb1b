#include "tools/progress.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace enfilade::tools {

namespace {
constexpr auto patience = std::chrono::seconds(1);
constexpr auto interval = std::chrono::milliseconds(100);
constexpr int width = 30;
}  // namespace

Progress::Progress(const Console& console, std::vector<std::string> steps) : steps_(std::move(steps)) {
    if (console.shows_progress() && !steps_.empty()) thread_ = std::thread([this] { loop(); });
}

Progress::~Progress() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Progress::next() {
    fraction_.store(0, std::memory_order_relaxed);
    step_.fetch_add(1, std::memory_order_relaxed);
    remark({});
}

void Progress::remark(std::string words) {
    const std::lock_guard lock(mutex_);
    remark_ = std::move(words);
}

void Progress::draw(double seconds) const {
    const std::size_t step = std::min(step_.load(std::memory_order_relaxed), steps_.size() - 1);
    const double inside = std::clamp(fraction_.load(std::memory_order_relaxed), 0.0, 1.0);
    const int filled = int((double(step) + inside) / double(steps_.size()) * width);
    std::string bar(std::size_t(filled), '=');
    if (filled < width) bar += '>';
    bar.resize(width, ' ');
    std::fprintf(stderr, "\r\033[K[%s] %s%s, %.0f s", bar.c_str(), steps_[step].c_str(),
                 remark_.empty() ? "" : (", " + remark_).c_str(), seconds);
    std::fflush(stderr);
}

void Progress::loop() {
    bool drawn = false;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, interval, [this] { return ends_; })) {
        const auto passed = std::chrono::steady_clock::now() - start_;
        if (passed < patience) continue;
        draw(std::chrono::duration<double>(passed).count());
        drawn = true;
    }
    if (drawn) std::fputs("\r\033[K", stderr);
}

}  // namespace enfilade::tools
