/// \file
/// A few threads that share a list of tasks.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tightflip::kernel {

[[nodiscard]] inline unsigned thread_count(unsigned wanted) noexcept {
    if (wanted > 0) return wanted;
    const unsigned available = std::thread::hardware_concurrency();
    return available > 0 ? available : 1;
}

/// Calls task(worker, i) once for each i < tasks, on `workers` threads of which the caller is one.
/// The first exception stops the hand-out of tasks and is thrown again here.
template <class Task>
void for_each_task(unsigned workers, std::size_t tasks, Task&& task) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex guard;
    const auto work = [&](unsigned worker) {
        try {
            for (std::size_t i = next++; i < tasks; i = next++)
                task(worker, i);
        } catch (...) {
            next = tasks;
            const std::lock_guard lock(guard);
            if (!failure) failure = std::current_exception();
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned worker = 1; worker < workers && worker < tasks; ++worker) {
        threads.emplace_back(work, worker);
    }
    work(0);
    threads.clear();  // joins
    if (failure) std::rethrow_exception(failure);
}

}  // namespace tightflip::kernel
