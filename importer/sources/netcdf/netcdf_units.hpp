// What the units attributes of a NetCDF-CF file say, and by what its numbers are multiplied so that times,
// lengths and velocities fit each other. (CF conventions 1.8, sections 3.1, 4.3 and 4.4)
#pragma once

#include "importer/sources/netcdf/netcdf_axes.hpp"

namespace wakesurf::importer {

struct NetcdfTimes {
    std::vector<double>
        seconds; ///< since the reference; in the file's own unit where that is not known
    std::string reference;
    std::string unit; ///< as the file states it, without the reference; empty where it does not
    std::string note; ///< what was converted or kept
};

/// Reads the time coordinate. @param reference  of the series' first file; empty for that one
/// Error: Unsupported (months and years of several time-steps, references that cannot be compared), Io.
core::Result<NetcdfTimes>
read_times(const NetcdfFile& file, const NetcdfVariable& time, const std::string& reference);

struct NetcdfUnit {
    double factor = 1.0;
    std::string unit; ///< of the values once multiplied
};

/// Velocities, momenta and densities come to m s-1, kg m-2 s-1 and kg m-3; everything else stays.
NetcdfUnit unit_of(const NetcdfFile& file, const NetcdfVariable& variable);

/// Returns what a person should know of the units beside those of the times; empty where all is as it seems.
/// @param velocity  names of the variables the velocity is made of
/// @param times     unit of the time coordinate, if there is one
std::string note_on_units(const NetcdfFile& file,
                          const NetcdfGrid& grid,
                          const std::vector<std::string>& velocity,
                          const std::optional<std::string>& times);

} // namespace wakesurf::importer
