#include "../src/parallel.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

TEST(ForEachTask, DoesEachTaskOnce) {
    for (const unsigned workers : {1U, 2U, 7U}) {
        std::vector<std::atomic<int>> done(100);
        std::atomic<bool> is_worker_in_range = true;
        for_each_task(workers, done.size(), [&](unsigned worker, std::size_t i) {
            ++done[i];
            if (worker >= workers) is_worker_in_range = false;
        });
        for (const auto& count : done)
            EXPECT_EQ(count, 1);
        EXPECT_TRUE(is_worker_in_range);
    }
}

TEST(ForEachTask, ThrowsOnTheCallersThreadWhatATaskThrew) {
    std::atomic<int> done = 0;
    const auto task = [&](unsigned, std::size_t i) {
        ++done;
        if (i == 5) throw std::runtime_error("task 5");
    };
    EXPECT_THROW(for_each_task(3, 1'000'000, task), std::runtime_error);
    EXPECT_LT(done, 1'000'000);
}

TEST(ForEachTask, HasNothingToDoWithoutTasks) {
    for_each_task(4, 0, [](unsigned, std::size_t) { FAIL(); });
}

TEST(ThreadCount, IsWhatIsAskedForOrAtLeastOne) {
    EXPECT_EQ(thread_count(3), 3U);
    EXPECT_GE(thread_count(0), 1U);
}

}  // namespace
}  // namespace tightflip::kernel
