#pragma once
// A bar on stderr for work over a second.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tools/console.h"

namespace enfilade::tools {

/// Draws "[=====>      ] Checking the model, 3 s" from the first second on, and takes it away when it ends.
/// Steps count equally; inside one, `fraction` moves the bar where the work can say how far it is.
class Progress {
public:
    Progress(const Console& console, std::vector<std::string> steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Begins the next step (the first one begins with the object).
    void next();
    /// How much of the current step is done, 0..1. May be called from any thread.
    void fraction(double done) { fraction_.store(done, std::memory_order_relaxed); }
    /// A few words behind the current step, until the next one. May be called from any thread.
    void remark(std::string words);

private:
    void draw(double seconds) const;
    void loop();

    std::vector<std::string> steps_;
    std::atomic<std::size_t> step_ = 0;
    std::atomic<double> fraction_ = 0;
    std::string remark_;  ///< under the mutex
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ends_ = false;
    std::thread thread_;  ///< last: it reads the others
};

}  // namespace enfilade::tools
