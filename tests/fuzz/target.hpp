// The fuzz targets: each takes any bytes and must return, with an error or without. Two programs run them: a
// test that replays the seeds and mutations of them in every ./check, and libFuzzer under sanitizers
// (README.md here).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::fuzz {

using Input = std::span<const std::uint8_t>;

struct Target {
    std::string_view name;
    void (*run)(Input input);            ///< throws or aborts only for a fault of the product
    std::vector<std::string> (*seeds)(); ///< inputs that are right, or nearly
    /// Its inputs are JSON, or lines that end with it: they are changed as such, too.
    bool json = false;
};

/// Returns the targets in the order of the table in README.md.
const std::vector<Target>& targets();

inline std::string_view text_of(Input input) {
    return {reinterpret_cast<const char*>(input.data()), input.size()};
}

/// Checks a property that must hold for any input; otherwise ends the process with the sentence.
void demand(bool holds, std::string_view sentence);

} // namespace wakesurf::fuzz
