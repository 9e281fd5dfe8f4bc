// Which axes of a Zarr's array are x, y, z, time and the component of a vector, and what lies along them.
#pragma once

#include "core/dataset/grid.hpp"
#include "server/service/zarr/chunk_objects.hpp"
#include "server/service/zarr/zarr_group.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Each is a number of an axis of the array.
struct ZarrAxes {
    std::array<std::size_t, 3> place{0, 0, 0}; ///< x, y, z
    std::optional<std::size_t> time;           ///< nothing: one time-step
    std::optional<std::size_t> component;      ///< of a vector, 3 long

    /// Nodes along x, y and z.
    std::array<std::uint64_t, 3> nodes(const ZarrArray& array) const;

    std::uint64_t steps(const ZarrArray& array) const { return time ? array.shape[*time] : 1; }

    bool operator==(const ZarrAxes&) const = default;
};

/// By the names of its axes where they say it, in any order; else (time, z, y, x), (time, z, y, x, component) and (time, component, z, y, x),
/// each without the time as well. Nothing for an array of other axes.
std::optional<ZarrAxes> zarr_axes(const ZarrArray& array);

struct ZarrCoordinates {
    core::Grid
        grid; ///< uniform where nodes are evenly spaced, to a millionth of that or to what single precision keeps, else rectilinear
    std::vector<double> times;
    std::string length_unit; ///< as its array states it; may be empty
    std::string time_unit;   ///< the same, without what times are counted from
    std::string
        note; ///< what a person should know: coordinates that there are none of; may be empty
};

/// Of the 1-D arrays that are named as the axes. Error: Unsupported for axes that are no lengths or fall, OverLimit for too many nodes or
/// time-steps; as ChunkObjects::read_line.
core::Result<ZarrCoordinates> zarr_coordinates(const ZarrGroup& group,
                                               const ZarrArray& array,
                                               const ZarrAxes& axes,
                                               const ChunkObjects& objects);

} // namespace wakesurf::server
