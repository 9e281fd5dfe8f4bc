// The units attributes of a NetCDF-CF file, and the factors that make its times, lengths and velocities fit
// each other. (CF conventions 1.8, sections 3.1, 4.3 and 4.4)
#pragma once

#include "importer/sources/netcdf/netcdf_grid.hpp"

namespace wakesurf::importer {

struct NetcdfTimes {
    /// The times in seconds since the reference; in the file's own unit if that is unknown.
    std::vector<double> seconds;
    std::string reference;
    /// The unit as the file states it, without the reference; empty if it states none.
    std::string unit;
    std::string note; ///< what was converted or kept
};

/// Reads the time coordinate. @param reference  of the series' first file; empty for that one
/// @param several  there are times in other files too
/// Error: Unsupported (months and years of several time-steps, references that cannot be compared), Io.
core::Result<NetcdfTimes> read_times(const NetcdfFile& file,
                                     const NetcdfVariable& time,
                                     const std::string& reference,
                                     bool several);

/// Reads the times of a file without a time coordinate: dates in a variable of text; of one time-step also an
/// attribute of the file. Seconds, of dates since `reference` or, if that is empty, the first. None if there are
/// none of as many time-steps.
std::optional<NetcdfTimes>
read_other_times(const NetcdfFile& file, std::size_t steps, const std::string& reference);

struct NetcdfUnit {
    double factor = 1.0;
    std::string unit; ///< of the values once multiplied
};

/// Converts velocities, momenta and densities to m s-1, kg m-2 s-1 and kg m-3; everything else stays.
NetcdfUnit unit_of(const NetcdfFile& file, const NetcdfVariable& variable);

/// Returns a note for users on the units, except those of the times; empty if all are plain.
/// @param velocity  names of the variables the velocity is made of
/// @param times     unit of the time coordinate, if there is one
std::string note_on_units(const NetcdfFile& file,
                          const NetcdfGrid& grid,
                          const std::vector<std::string>& velocity,
                          const std::optional<std::string>& times);

} // namespace wakesurf::importer
