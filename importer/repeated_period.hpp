// One stored period of a flow that repeats -> a series of several (--loop).
#pragma once

#include "importer/import_plan.hpp"

namespace wakesurf::importer {

/// Repeats the time-steps of a plan, and says so in its note. The last one is left out if it is the first again;
/// else the period goes on from it to the first for as long as between the two before, unless `loop` states its
/// length. The series ends with the first time-step once more. Error: InvalidArgument, beginning with --loop
/// (fewer than two time-steps, a period shorter than they are, one that the data end within), OverLimit (more
/// than a million time-steps), and what reading the first two and the last one reports.
core::Result<void> repeat_period(const command::Loop& loop, ImportPlan& plan);

} // namespace wakesurf::importer
