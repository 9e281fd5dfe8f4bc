// Which things of a list are meant, as runs of consecutive ones; and what becomes of a list when some go. protocol/wire/FORMAT.md,
// Topology. Twin: web-client/src/protocol/runs.ts.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Things begin .. end - 1 of a list.
struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    bool operator==(const Run&) const = default;
};

/// Disjoint and ascending.
class Runs {
  public:
    /// REQUIRES: `index` is above everything taken so far.
    void take(std::uint32_t index) { take({index, index + 1}); }

    /// A gap of at most `bridge` things to the run before is taken as well.
    void take(Run run, std::uint32_t bridge = 0);

    std::span<const Run> all() const { return runs_; }

    std::uint32_t count() const { return count_; }

    bool operator==(const Runs&) const = default;

  private:
    std::vector<Run> runs_;
    std::uint32_t count_ = 0;
};

/// The number each of `count` things has when the removed ones are gone, `core::no_vertex` for those.
std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count);

/// Calls each(begin, end) for the runs of those of `count` things that are not taken.
template <class Each>
void for_each_gap(const Runs& taken, std::uint32_t count, Each each) {
    std::uint32_t at = 0;
    for (const Run& run : taken.all()) {
        if (at < run.begin)
            each(at, run.begin);
        at = run.end;
    }
    if (at < count)
        each(at, count);
}

/// The things that stay where `removed` go, in order.
template <class T>
std::vector<T> without(const Runs& removed, std::span<const T> things) {
    std::vector<T> left;
    left.reserve(things.size() - removed.count());
    for_each_gap(removed, static_cast<std::uint32_t>(things.size()),
                 [&](std::uint32_t begin, std::uint32_t end) {
                     const auto run = things.subspan(begin, end - begin);
                     left.insert(left.end(), run.begin(), run.end());
                 });
    return left;
}

} // namespace wakesurf::protocol
