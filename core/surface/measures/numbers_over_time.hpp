// The numbers of a surface at several times, one row each: what is written as CSV and answered by `surface.numbers`.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/measures/measured_surface.hpp"
#include "core/surface/measures/region.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// A table, one row a time.
struct NumberTable {
    std::vector<NamedNumber> columns;            ///< their values are those of the last row
    std::vector<std::vector<double>> rows;       ///< not_known where a number is not
    std::vector<std::vector<std::string>> notes; ///< of each row; empty: nothing is said
    SurfaceStatistics statistics;                ///< of the last time
};

/// Builds a surface once and measures it at each time.
///
/// @param times    at least one, in the order in which the surface moves; of a stream surface `from` plus the age
/// @param through  nothing: what needs a plane or a box is left out
/// @param fields   whose means over the surface are wanted
/// Error: as Evolution and MeasuredSurface; where the errors between stored times cannot be estimated, the notes say why.
/// Cost: as the surface, that of stating its interval errors (of streak and time surfaces at each time) and of
/// MeasuredSurface. The same numbers for any number of threads.
Result<NumberTable> numbers_over_time(SurfacePlan plan,
                                      std::span<const double> times,
                                      const std::optional<Region>& through,
                                      std::span<const AveragedField> fields,
                                      const Clock& clock,
                                      const std::stop_token& stop,
                                      const WorkPart& work = {});

} // namespace wakesurf::core
