// Inputs made from others without a fuzzer's feedback: bytes changed, cut, doubled and crossed with another
// seed. Deterministic, so that what fails in ./check fails again.
#pragma once

#include "tests/fuzz/random.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace wakesurf::fuzz {

/// Returns a mutation of one of the seeds. REQUIRES: seeds.
inline std::string mutate(const std::vector<std::string>& seeds, Random& random) {
    std::string out = seeds[below(seeds.size(), random)];
    for (std::size_t round = 1 + below(4, random); round > 0; --round) {
        const std::size_t at = below(out.size() + 1, random),
                          size = below(std::min<std::size_t>(64, out.size() - at) + 1, random);
        switch (random() % 6) {
        case 0: // a byte
            if (at < out.size())
                out[at] = static_cast<char>(random());
            break;
        case 1: // a bit
            if (at < out.size())
                out[at] = static_cast<char>(out[at] ^ (1 << random() % 8));
            break;
        case 2: // left out
            out.erase(at, size);
            break;
        case 3: // said twice
            out.insert(at, out.substr(at, size));
            break;
        case 4: { // out of another
            const std::string& other = seeds[below(seeds.size(), random)];
            out.insert(at, other.substr(below(other.size() + 1, random), size));
            break;
        }
        default: // a number in text made extreme
            static const char* const numbers[] = {"-1",   "0",          "1e308",
                                                  "-0.0", "4294967296", "9223372036854775808"};
            out.insert(at, numbers[below(std::size(numbers), random)]);
        }
    }
    return out;
}

} // namespace wakesurf::fuzz
