// The colour map viridis (Smith, van der Walt; CC0) for files that carry colours. Near twin:
// web-client/src/scene/surface/colourMap.ts, its table of 256.
#pragma once

#include <array>
#include <cstdint>

namespace wakesurf::protocol {

/// Returns the sRGB colour of a value from 0 to 1; other values get the colour of the nearer end, NaN the
/// lower one's. Within 4 of 255 of the table.
std::array<std::uint8_t, 3> viridis(double value);

} // namespace wakesurf::protocol
