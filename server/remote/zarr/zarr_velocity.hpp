// The choice of a Zarr's velocity, by the names of arrays and their axes. Below
// server/remote/zarr/zarr_dataset.hpp.
#pragma once

#include "core/base/result.hpp"
#include "server/remote/zarr/zarr_axes.hpp"

#include <string>
#include <vector>

namespace wakesurf::server {

/// Names an array that has a value at each node.
struct ZarrField {
    const ZarrArray* array;
    ZarrAxes axes;
};

struct ZarrVelocity {
    std::vector<ZarrField> parts; ///< one vector, or three scalars
    std::string name;
    std::string why;
};

/// Returns the fields of a group.
std::vector<ZarrField> zarr_fields(const ZarrGroup& group);

/// Chooses a vector with the name of a velocity, else three arrays with the names of its components, else the
/// only vector. Error: NotFound, InvalidArgument (several velocities), Unsupported (staggered grids); that of
/// an unreadable array that would be chosen.
core::Result<ZarrVelocity> choose_zarr_velocity(const ZarrGroup& group,
                                                const std::vector<ZarrField>& fields);

} // namespace wakesurf::server
