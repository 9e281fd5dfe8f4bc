// Random numbers for mutations: the same on every run, and quick to seed, because libFuzzer gives a seed with
// every input.
#pragma once

#include <cstddef>
#include <random>

namespace wakesurf::fuzz {

using Random = std::minstd_rand;

/// Returns a number below `count`; 0 if that is 0.
inline std::size_t below(std::size_t count, Random& random) {
    return count == 0 ? 0 : random() % count;
}

} // namespace wakesurf::fuzz
