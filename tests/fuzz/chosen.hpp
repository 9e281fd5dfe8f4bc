// The target of a program of libFuzzer's; the build names it (chosen.cpp.in).
#pragma once

#include "tests/fuzz/target.hpp"

namespace wakesurf::fuzz {

extern const Target& chosen;

} // namespace wakesurf::fuzz
