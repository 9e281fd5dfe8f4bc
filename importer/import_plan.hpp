// Everything about a source that is known before its time-steps are converted.
#pragma once

#include "command/source_options.hpp"
#include "core/base/result.hpp"
#include "importer/base/source.hpp"
#include "importer/fields/field_choice.hpp"
#include "importer/time_selection.hpp"
#include "store/step_placement.hpp"
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
    command::SourceOptions taken;
    core::Precision precision = core::Precision::Single;
    store::StepPlacement placement = store::StepPlacement::Auto;
    std::string
        selection; ///< all of these as the user wrote them, part of what the store was made from
    std::size_t jobs = 0; ///< processes that convert time-steps; 0: as many as there are cores
    std::uint64_t memory =
        0; ///< bytes that all processes together may take; 0: half of what is free
};

struct ImportPlan {
    std::unique_ptr<Source> source;
    std::vector<std::size_t> steps; ///< of the source, in order
    std::vector<double> times;
    std::string time_note; ///< where they come from, if that is not plain
    FieldChoice choice;
    core::Precision precision = core::Precision::Single;
    store::StepPlacement placement = store::StepPlacement::Auto;
    std::size_t jobs = 0;
    std::uint64_t memory = 0; ///< as ImportRequest
    store::StoreSource made_from;

    /// For messages: "flow_3.vti (time-step 3)".
    std::string step_name(std::size_t index) const;

    core::Result<SourceStep> read(std::size_t index) const {
        return source->read(steps[index], choice.arrays());
    }
};

/// Told what the velocity could be, where that is not clear: velocity_candidates.
using UnclearVelocity = std::function<void(std::vector<std::string>)>;

/// Opens the source. Error: as open_source, choose_fields and select_times; Corrupt for times that do not rise; InvalidArgument,
/// beginning with the option, for --dt or --start where the source states its times.
core::Result<ImportPlan> make_plan(const ImportRequest& request,
                                   const UnclearVelocity& unclear = {});

/// The same of a source that is open.
core::Result<ImportPlan> plan_of(std::unique_ptr<Source> source,
                                 const ImportRequest& request,
                                 const UnclearVelocity& unclear = {});

/// An error about a time-step that was not told which. @param error  to be read after the name
core::Error about_step(const ImportPlan& plan, std::size_t index, core::Error error);

} // namespace wakesurf::importer
