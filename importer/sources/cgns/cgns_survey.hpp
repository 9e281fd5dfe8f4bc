// What a CGNS file says about its time-steps, read with the CGNS library: what vtkCGNSReader decides without
// a word. CFD General Notation System, Standard Interface Data Structures, chapter 11 (time-dependent flow).
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

struct CgnsUnits {
    /// Multiplies coordinates, so that they are in the unit of length of the velocities.
    double coordinates = 1.0;
    /// Says what was converted; may be empty.
    std::string note;
};

struct CgnsSurvey {
    /// Are those of BaseIterativeData, as they are; empty where there are none.
    std::vector<double> times;
    CgnsUnits units;
    /// Says that cells of a zone have not the numbers 1 to their count: elements of boundaries come before
    /// them.
    bool cells_have_other_numbers = false;
};

/// Looks at all but the values. Error: Corrupt (not CGNS, cut off, pointers that do not fit the number of
/// time-steps), Unsupported (no three-dimensional base; bases with times of their own; several solutions at
/// one place without times: which is it?; zones in different units).
core::Result<CgnsSurvey> survey_cgns(const ListedFile& file);

} // namespace wakesurf::importer
