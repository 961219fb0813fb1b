#include "accel/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace enfilade::accel {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
    for (const unsigned threads : {1u, 2u, 7u}) {
        std::vector<int> visits(1000, 0);
        parallel_for(ThreadExecutor(threads), visits.size(), 13, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        EXPECT_EQ(visits, std::vector<int>(1000, 1));
    }
}

TEST(ParallelFor, PassesAnExceptionOnAfterTheOthersHaveEnded) {
    std::atomic<int> done = 0;
    EXPECT_THROW(ThreadExecutor(4).run(64,
                                       [&](std::size_t chunk) {
                                           if (chunk == 3) throw std::runtime_error("three");
                                           ++done;
                                       }),
                 std::runtime_error);
    EXPECT_EQ(done, 63);
}

TEST(ParallelFor, DoesNothingForNothing) {
    parallel_for(ThreadExecutor(), 0, 16, [](std::size_t, std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace enfilade::accel
