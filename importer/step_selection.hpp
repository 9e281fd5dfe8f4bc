// Which of a source's time-steps are imported: those of --times that have the velocity, with the fields that all of these have.
// Programs write the first time-step, or some between, without it.
#pragma once

#include "core/base/result.hpp"
#include "importer/base/source.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Holds T0:T1[:EVERY] of --times: both ends included, every EVERY-th time-step.
struct TimeSelection {
    double from = 0.0;
    double to = 0.0;
    std::size_t every = 1;
};

/// Parses ranges with commas between them: 8:10,12:16 leaves out a time-step between them, which may be
/// damaged. Error: InvalidArgument, beginning with "--times".
core::Result<std::vector<TimeSelection>> parse_times(const std::string& text);

/// Returns the indices into `times` that one of the ranges holds, all of them without ranges. Error:
/// OutOfTime if they hold none.
core::Result<std::vector<std::size_t>> select_times(std::span<const double> times,
                                                    const std::vector<TimeSelection>& ranges);

struct StepFields {
    std::vector<std::size_t> steps; ///< those with the velocity
    std::size_t described = 0;      ///< the one that the source is described by
    bool none = false;              ///< no time-step has a velocity
    std::vector<core::FieldInfo> fields;
    std::string note; ///< what is left out, and why; may be empty
};

/// Describes the source by the first of `steps` with a velocity, as choose_velocity finds it, and leaves out
/// the others that are known to lack that velocity. All steps stay where none has one, or the choice is not
/// clear. A step that cannot be read stays, and is reported when the import reaches it. Error: as
/// Source::describe_by of the first.
/// @param times  of all time-steps of the source
core::Result<StepFields> settle_fields(Source& source,
                                       const std::vector<std::size_t>& steps,
                                       const std::vector<double>& times,
                                       const std::string& wish);

} // namespace wakesurf::importer
