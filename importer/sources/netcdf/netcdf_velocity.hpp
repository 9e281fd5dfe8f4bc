// What NetCDF variables state of a velocity: their standard names (CF conventions 1.8, section 3.3) say which
// component they are, whatever they are called, and which way it points.
#pragma once

#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/netcdf/netcdf_file.hpp"

namespace wakesurf::importer {

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
