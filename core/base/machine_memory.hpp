// How much memory the machine has: the limit where an allocation fails.
#pragma once

#include <cstdint>

namespace wakesurf::core {

/// Bytes; 0 where the system does not say.
std::uint64_t machine_memory();

} // namespace wakesurf::core
