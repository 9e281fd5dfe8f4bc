// Work for the compute threads whose result is wanted on the loop's thread.
#pragma once

#include "core/base/result.hpp"
#include "server/base/loop.hpp"
#include "server/live/compute/compute_pool.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Runs `work` in the pool and hands its result to `done` on the loop; work that runs out of memory returns
/// OverLimit. REQUIRES: loop and pool outlive the work.
/// @param line  whose turn it takes, see ComputePool::run; work of one line runs one after the other
template <class T>
void compute(Loop& loop,
             ComputePool& pool,
             const std::string& line,
             std::function<core::Result<T>()> work,
             std::function<void(core::Result<T>)> done) {
    pool.run(line, PriorityClass::Long, [&loop, work = std::move(work), done = std::move(done)] {
        auto result = std::make_shared<core::Result<T>>(
            core::fail(core::Error::Code::OverLimit, "there is not enough memory for this",
                       "ask for less at once"));
        try {
            *result = work();
        } catch (const std::bad_alloc&) { // said above
        }
        loop.post([result, done] { done(std::move(*result)); });
    });
}

/// Runs work that takes turns of its own, like a session.
template <class T>
void compute(Loop& loop,
             ComputePool& pool,
             std::function<core::Result<T>()> work,
             std::function<void(core::Result<T>)> done) {
    static std::atomic<std::uint64_t> next = 0;
    compute<T>(loop, pool, "\nlone " + std::to_string(++next), std::move(work), std::move(done));
}

} // namespace wakesurf::server
