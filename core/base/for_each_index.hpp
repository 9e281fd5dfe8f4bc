// A loop over independent numbers on all threads there are.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace wakesurf::core {

/// Visits 0 to `count` - 1, each once, in no order. A thread that waits for the others runs no other task
/// meanwhile.
template <class Visit>
void for_each_index(std::size_t count, Visit visit) {
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                visit(i);
        });
    });
}

} // namespace wakesurf::core
