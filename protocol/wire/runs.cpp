#include "protocol/wire/runs.hpp"

#include <algorithm>
#include <numeric>

namespace wakesurf::protocol {

void Runs::take(Run run, std::uint32_t bridge) {
    if (!runs_.empty() && run.begin - runs_.back().end <= bridge) {
        count_ += run.end - runs_.back().end;
        runs_.back().end = run.end;
    } else {
        count_ += run.end - run.begin;
        runs_.push_back(run);
    }
}

std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count) {
    std::vector<std::uint32_t> now(count, core::no_vertex);
    std::uint32_t next = 0;
    for_each_gap(removed, count, [&](std::uint32_t begin, std::uint32_t end) {
        std::iota(now.begin() + begin, now.begin() + end, next);
        next += end - begin;
    });
    return now;
}

} // namespace wakesurf::protocol
