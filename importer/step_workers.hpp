// Time-steps converted by several processes at once: VTK's readers are not thread-safe, and a reader that
// crashes on a damaged file takes only its own process along. Only this process commits their files, strictly
// in order, so that a store has the same bytes for any number of processes.
#pragma once

#include "core/base/result.hpp"
#include "importer/step_conversion.hpp"

#include <functional>
#include <span>
#include <string>

namespace wakesurf::importer {

struct StepWork {
    /// Called once in each process before its first time-step. May be empty.
    std::function<core::Result<void>()> begin;
    /// Called in the processes.
    std::function<core::Result<StepRecord>(std::size_t index)> convert;
    /// Called in this process, in order.
    std::function<core::Result<void>(std::size_t index, const StepRecord& record)> commit;
    /// Returns the name of a time-step for messages.
    std::function<std::string(std::size_t index)> name;
    /// Called in this process once the workers are busy. May be empty.
    std::function<core::Result<void>()> meanwhile;
};

/// Converts the time-steps `todo` (rising) in `jobs` processes. Ends with the first error in order of
/// time-steps: those before it are committed. A process that crashes counts as an error of its time-step.
core::Result<void>
convert_steps(std::span<const std::size_t> todo, std::size_t jobs, const StepWork& work);

/// Ends the processes of convert_steps and waits until they are gone. May be called in a signal handler.
void end_step_workers();

} // namespace wakesurf::importer
