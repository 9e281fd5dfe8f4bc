// Loops over independent numbers on all threads there are.
#pragma once

#include "core/base/loop_times.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace wakesurf::core {

/// Calls `visit(begin, end)` for ranges that cover 0 to `count` - 1 once, in no order. A thread that waits for the others runs no
/// other task meanwhile.
/// @param grain  ranges longer than this are divided
template <class Visit>
void for_each_range(std::size_t count, std::size_t grain, const Visit& visit) {
    const LoopTimes::Loop timed(count, grain);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                          [&](const auto& range) { visit(range.begin(), range.end()); });
    });
}

/// Visits 0 to `count` - 1, each once, in no order.
/// @param grain  how many are too few to be shared among threads
template <class Visit>
void for_each_index(std::size_t count, const Visit& visit, std::size_t grain = 1024) {
    for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i)
            visit(i);
    });
}

/// Returns what `visit(i, found)` appends to `found` for 0 to `count` - 1, in that order, whatever the number of threads.
template <class Found, class Visit>
std::vector<Found> gather(std::size_t count, const Visit& visit, std::size_t grain = 1024) {
    std::vector<std::vector<Found>> parts((count + grain - 1) / grain);
    for_each_index(
        parts.size(),
        [&](std::size_t part) {
            for (std::size_t i = part * grain; i < std::min(count, (part + 1) * grain); ++i)
                visit(i, parts[part]);
        },
        1);
    if (parts.size() == 1)
        return std::move(parts.front());
    std::size_t size = 0;
    for (const auto& part : parts)
        size += part.size();
    std::vector<Found> all;
    all.reserve(size);
    for (const auto& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// Sorts on all threads, with the same result for any number of them: things of which neither is before the other are the
/// same in everything.
template <class Thing, class Before>
void sort_all(std::vector<Thing>& things, const Before& before) {
    // One thread makes the first division, two the next and so on: of n log2(n) steps 2 n are in a row.
    const LoopTimes::Loop timed(static_cast<std::size_t>(std::bit_width(things.size()) / 2 + 1), 1);
    tbb::this_task_arena::isolate(
        [&] { tbb::parallel_sort(things.begin(), things.end(), before); });
}

/// Returns the largest of `value(i)` for 0 to `count` - 1, and at least `most`.
template <class Value>
double largest(std::size_t count, double most, const Value& value, std::size_t grain = 4096) {
    std::vector<double> parts((count + grain - 1) / grain, most);
    for_each_index(
        parts.size(),
        [&](std::size_t part) {
            for (std::size_t i = part * grain; i < std::min(count, (part + 1) * grain); ++i)
                parts[part] = std::max(parts[part], value(i, parts[part]));
        },
        1);
    for (const double part : parts)
        most = std::max(most, part);
    return most;
}

} // namespace wakesurf::core
