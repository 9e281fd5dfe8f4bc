// The units of length that a CGNS file states for its coordinates and for its velocities: DimensionalUnits_t of an array, or of what
// it lies in. (CGNS Standard Interface Data Structures 4.2, sections 2.4 and 4.3; times are always in seconds there.)
#pragma once

#include "core/base/result.hpp"

#include <string>

namespace wakesurf::importer {

struct CgnsUnits {
    double coordinates =
        1.0; ///< what they are multiplied by, to be in the unit of length of the velocities
    std::string note; ///< what was converted; may be empty
};

/// Nothing is converted where one of the two states no unit, or both the same.
/// Error: Unsupported (zones in different units), Io. @param id  as the CGNS library opened the file
core::Result<CgnsUnits> read_cgns_units(int id, const std::string& file);

} // namespace wakesurf::importer
