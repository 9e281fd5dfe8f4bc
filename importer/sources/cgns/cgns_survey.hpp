// What a CGNS file says about its time-steps, read with the CGNS library: what vtkCGNSReader decides without a word.
// CFD General Notation System, Standard Interface Data Structures, chapter 11 (time-dependent flow).
#pragma once

#include "importer/sources/cgns/cgns_units.hpp"
#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

struct CgnsSurvey {
    std::vector<double> times; ///< of BaseIterativeData, as they are; empty where there are none
    CgnsUnits units;
    bool cells_have_other_numbers =
        false; ///< than 1 to their count, in a zone: elements of boundaries come before them
};

/// Error: Corrupt (not CGNS, cut off, pointers that do not fit the number of time-steps), Unsupported (no
/// three-dimensional base; bases with times of their own; several solutions at one place without times: which is it?;
/// zones in different units).
core::Result<CgnsSurvey> survey_cgns(const ListedFile& file);

} // namespace wakesurf::importer
