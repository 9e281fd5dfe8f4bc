// How much room arrays take that grow a little at a time and are large: a vector alone would double, and hold
// up to twice what is needed.
#pragma once

#include <cstddef>

namespace wakesurf::core {

/// A thirty-second more, so that it is not moved each time.
inline std::size_t with_spare(std::size_t elements) {
    return elements + elements / 32;
}

} // namespace wakesurf::core
