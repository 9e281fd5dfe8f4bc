// Where a sheet bends across its columns: cells on either side of a column that meet at too large an angle.
// What the strips then split at, as they do on divergence.
#pragma once

#include "core/surface/columns/strip.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Returns for every strip and node of its tree the first of its rows that bends and is wide enough to be
/// split, or Strip::no_row. Inner vectors of strips that bend nowhere are empty.
/// @param closed        the last strip's right column is the first one's left
/// @param least_cosine  of the angle between the normals of cells that may stay
/// Cost: O(quads), in parallel.
std::vector<std::vector<std::uint32_t>>
find_bends(std::span<const Strip> strips, bool closed, double least_cosine, double least_width);

} // namespace wakesurf::core
