// The time-steps of a CGNS file, read with the CGNS library: vtkCGNSReader would choose among them without a
// message. CFD General Notation System, Standard Interface Data Structures, chapter 11 (time-dependent flow).
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

struct CgnsUnits {
    /// The factor from coordinates to the unit of length of the velocities.
    double coordinates = 1.0;
    /// Says what was converted; may be empty.
    std::string note;
};

struct CgnsSurvey {
    /// The times of BaseIterativeData, as they are; empty if there are none.
    std::vector<double> times;
    CgnsUnits units;
    int dimension = 3; ///< of the cells that are read: 2 of a plane
    /// True if cells of a zone are not numbered from 1 to their count: elements of boundaries come before
    /// them.
    bool cells_have_other_numbers = false;
};

/// Reads everything but the values. Error: Corrupt (not CGNS, cut off, pointers that do not fit the number of
/// time-steps), Unsupported (no base with cells in space or in a plane; bases with times of their own; several solutions at
/// one place without times, which are ambiguous; zones in different units).
core::Result<CgnsSurvey> survey_cgns(const ListedFile& file);

} // namespace wakesurf::importer
