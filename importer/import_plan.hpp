// Everything about a source that is known before its time-steps are converted.
#pragma once

#include "core/base/result.hpp"
#include "importer/base/source.hpp"
#include "importer/fields/field_choice.hpp"
#include "importer/step_selection.hpp"
#include "store/command/source_options.hpp"
#include "store/store_layout.hpp"
#include "store/store_manifest.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct ImportRequest {
    std::filesystem::path source;
    std::vector<std::string> fields;
    std::vector<TimeSelection> times; ///< ranges; none: all
    /// A server follows the source: a time-step that cannot be read may be whole soon. Its time is kept, and the
    /// import ends there with an error; else the data end before it.
    bool growing = false;
    command::SourceOptions taken;
    core::Precision precision = core::Precision::Single;
    store::StepPlacement placement = store::StepPlacement::Auto;
    /// These ranges as the user wrote them; the store records them.
    std::string selection;
    std::size_t jobs = 0; ///< processes that convert time-steps; 0: as many as there are cores
    /// The memory that all processes together may take, in bytes; 0: half of what is free.
    std::uint64_t memory = 0;
};

struct ImportPlan {
    std::unique_ptr<Source> source;
    std::vector<std::size_t> steps; ///< of the source, in order
    std::size_t described = 0;      ///< the step of the source that it is described by
    std::vector<double> times;
    std::size_t period_steps = 0; ///< after which the time-steps repeat; 0: they do not
    std::string time_note; ///< where they come from, if that is not plain, and which are left out
    std::vector<core::FieldInfo> fields; ///< of the source, those that all time-steps have
    std::string end_note; ///< why the data end before the last time-step asked for; else empty
    FieldChoice choice;
    core::PeriodicAxes demanded{}; ///< by --periodic: along these the flow has to repeat
    core::Precision precision = core::Precision::Single;
    store::StepPlacement placement = store::StepPlacement::Auto;
    std::size_t jobs = 0;
    std::uint64_t memory = 0;     ///< as ImportRequest
    store::StoreSource made_from; ///< also of the time-step that the data end before

    /// Returns a name for messages: "flow_3.vti (time-step 3)".
    std::string step_name(std::size_t index) const;

    core::Result<SourceStep> read(std::size_t index) const;
};

/// Receives the velocities to choose from (velocity_candidates), if the choice is not clear.
using UnclearVelocity = std::function<void(std::vector<std::string>)>;

/// Opens the source and plans its import. Error: as open_source, choose_fields and select_times; Corrupt for
/// times that do not rise; InvalidArgument, beginning with the option, for --dt or --start if the source
/// states its times.
core::Result<ImportPlan> make_plan(const ImportRequest& request,
                                   const UnclearVelocity& unclear = {});

/// Returns the note on data that end before `time`.
std::string note_on_end(double time, const core::Error& why);

/// Plans the import of a source that is open, and fails like make_plan.
core::Result<ImportPlan> plan_of(std::unique_ptr<Source> source,
                                 const ImportRequest& request,
                                 const UnclearVelocity& unclear = {});

/// Adds the name of the time-step to an error. @param error  to be read after the name
core::Error about_step(const ImportPlan& plan, std::size_t index, core::Error error);

} // namespace wakesurf::importer
