// The axes of a Zarr's array: which are x, y, z, time and the component of a vector, and the coordinates
// along them.
#pragma once

#include "core/dataset/grid.hpp"
#include "server/remote/zarr/chunk_objects.hpp"
#include "server/remote/zarr/zarr_group.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Holds numbers of axes of the array.
struct ZarrAxes {
    std::array<std::size_t, 3> place{0, 0, 0}; ///< x, y, z
    std::optional<std::size_t> time;           ///< empty: one time-step
    std::optional<std::size_t> component;      ///< of a vector, 3 long

    /// Returns the numbers of nodes along x, y and z.
    std::array<std::uint64_t, 3> nodes(const ZarrArray& array) const;

    std::uint64_t steps(const ZarrArray& array) const { return time ? array.shape[*time] : 1; }

    bool operator==(const ZarrAxes&) const = default;
};

/// Finds the axes by their names, in any order; else by the orders (time, z, y, x), (time, z, y, x,
/// component) and (time, component, z, y, x), each without the time as well. Empty for an array of other
/// axes.
std::optional<ZarrAxes> zarr_axes(const ZarrArray& array);

struct ZarrCoordinates {
    /// The grid: uniform if nodes are evenly spaced, to a millionth of the spacing or to the rounding of
    /// single precision, else rectilinear.
    core::Grid grid;
    std::vector<double> times;
    std::string length_unit; ///< as its array states it; may be empty
    std::string time_unit;   ///< likewise, without the reference time
    /// A note for the user on missing coordinates; may be empty.
    std::string note;
};

/// Reads the 1-D arrays with the names of the axes. Error: Unsupported for axes that are no lengths or fall,
/// OverLimit for too many nodes or time-steps; as ChunkObjects::read_line.
core::Result<ZarrCoordinates> zarr_coordinates(const ZarrGroup& group,
                                               const ZarrArray& array,
                                               const ZarrAxes& axes,
                                               const ChunkObjects& objects);

} // namespace wakesurf::server
