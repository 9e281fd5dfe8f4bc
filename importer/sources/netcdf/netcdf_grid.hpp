// The grid of a NetCDF-CF file: the variables that are on common nodes, and where those are; of a file that has none, what it holds
// instead and what to do.
#pragma once

#include "core/dataset/dataset_info.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/netcdf/netcdf_conventions.hpp"
#include "importer/sources/netcdf/netcdf_file.hpp"

namespace wakesurf::importer {

struct NetcdfGridVariable {
    std::string name;
    std::optional<int> components; ///< the dimension along which the three of a vector are
};

struct NetcdfGrid {
    std::array<NetcdfAxis, 3> axes; ///< x, y, z; of a plane one has no dimension, which is -1
    std::optional<int> time;        ///< dimension
    /// The variables on this grid: each has the dimensions of the axes, each once, in any order. At least one.
    std::vector<NetcdfGridVariable> variables;
    std::string note; ///< what else there is
};

/// Returns the names of components across a plane that are not among its `fields`, by names or as stated.
std::vector<std::string> lacking_components(const std::vector<core::FieldInfo>& fields,
                                            const std::vector<StatedComponents>& stated,
                                            int across);

/// Returns the grid of the variables, of several that which has `velocity` or, if that is empty, one; in metres if the file states a unit of length. Error: Unsupported
/// (velocities on staggered grids, curvilinear or spherical coordinates, axes that are
/// no lengths), Corrupt, Io.
core::Result<NetcdfGrid> find_grid(const NetcdfFile& file, const std::string& velocity);

} // namespace wakesurf::importer
