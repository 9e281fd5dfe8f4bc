// What a NetCDF file states by the CF conventions (1.8): the dimensions that are x, y, z and time, the coordinates of nodes along
// them, and which variables are components of a velocity, and which way they point, by their standard names (section 3.3).
#pragma once

#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/netcdf/netcdf_file.hpp"

#include <array>

namespace wakesurf::importer {

enum class AxisKind { X, Y, Z, Time, Unknown };

/// Returns the variable that has the coordinates along a dimension: the one of its name, or else the one
/// along it that states that it is an axis, or is named like one (xh along ni). Null if there is none, or
/// several.
const NetcdfVariable* coordinates_of(const NetcdfFile& file, int dimension);

/// Returns the kind of an axis: by the coordinate variable's axis attribute, units ("... since ..."),
/// standard name and positive attribute, then by the name of the dimension. Error: Unsupported (longitude and
/// latitude, pressure or sigma levels: no lengths).
core::Result<AxisKind> axis_kind(const NetcdfFile& file, int dimension);

/// Returns the variable of one value that has the time of the whole file: by its standard name, its own name, or
/// else a reference in its units, or as a coordinate of others with a unit of time. Null if there is none, or if several might be.
const NetcdfVariable* time_of_all(const NetcdfFile& file);

struct NetcdfAxis {
    int dimension = 0;
    std::vector<double> nodes; ///< strictly rising
    bool flipped = false;      ///< stored falling
    bool down = false;         ///< stored as a depth: the nodes are heights
    bool by_name = false;      ///< a depth by its name alone
    bool numbered = false;     ///< the file has no coordinates: 0, 1, 2, ...
    std::string units{};       ///< as the file states them
    bool known = false;        ///< a unit of length
    double factor = 1.0;       ///< the factor that made the nodes metres
};

/// Reads an axis. A depth, positive downwards by its attribute or its name, becomes a height. Error: Corrupt (coordinates that are
/// missing, not finite, neither rising nor falling).
core::Result<NetcdfAxis> read_axis(const NetcdfFile& file, int dimension);

/// Returns every three of `names` whose standard names make them the components x, y and z of one fluid's
/// velocity. Components along the axes (x_wind) go before those by the compass (eastward_wind), where a file
/// has both. @param level  of a plane along x and y: without a component z, its standard name stands for it
std::vector<StatedComponents>
stated_velocities(const NetcdfFile& file, const std::vector<std::string>& names, bool level);

/// Returns true of a component that is stated to point west, south or down, by its standard name, else by its
/// `positive` attribute or long name; and of one along a z axis that counts downwards (sea_water_z_velocity).
bool points_backward(const NetcdfFile& file, const NetcdfVariable& variable, bool z_down);

/// Returns what a vertical component in the file is if that is no velocity: the rate of change of pressure,
/// or the like. Empty if it may be one.
std::string stated_tendency(const NetcdfFile& file, const NetcdfVariable& variable);

/// Refuses a velocity with such a component, or one that lacks only its vertical component where there is such
/// a variable. Error: Unsupported. @param velocity  the names of the chosen variables; empty if there are none
core::Result<void> refuse_tendencies(const NetcdfFile& file,
                                     const std::vector<std::string>& velocity);

} // namespace wakesurf::importer
