// A selection of a list's elements, as runs of consecutive ones; and the list after some are removed.
// protocol/wire/FORMAT.md, Topology. Twin: web-client/src/protocol/bytes.ts.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Stands for the elements begin .. end - 1 of a list.
struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    bool operator==(const Run&) const = default;
};

/// Holds disjoint, ascending runs.
class Runs {
  public:
    /// REQUIRES: `index` is above everything taken so far.
    void take(std::uint32_t index) { take({index, index + 1}); }

    /// Takes a run. A gap of at most `bridge` elements to the run before is taken as well.
    void take(Run run, std::uint32_t bridge = 0);

    std::span<const Run> all() const { return runs_; }

    std::uint32_t count() const { return count_; }

    bool operator==(const Runs&) const = default;

  private:
    std::vector<Run> runs_;
    std::uint32_t count_ = 0;
};

/// Returns the number that each of `count` elements has once the removed ones are gone, `core::no_vertex` for
/// those.
std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count);

/// Calls each(begin, end) for the runs of those of `count` elements that are not taken.
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

/// Returns the elements that stay, in order.
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
