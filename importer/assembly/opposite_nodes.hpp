// The nodes of a grid that are one where its flow repeats: on opposite sides of its box, at the same place of either.
#pragma once

#include "core/base/periodic_axes.hpp"
#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wakesurf::importer {

/// Two nodes, first that of the side of lower coordinates.
using OppositeNodes = std::vector<std::array<std::uint32_t, 2>>;

/// Returns the pairs along one axis. Error, to be read after the file's name: Unsupported where a node of one side has
/// none on the other.
/// @param nodes  so many, the first ones, are looked at
core::Result<OppositeNodes>
opposite_nodes(const core::Grid& grid, std::size_t axis, std::size_t nodes);

} // namespace wakesurf::importer
