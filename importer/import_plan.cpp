#include "importer/import_plan.hpp"

#include "importer/assembly/obstacle_mask.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/repeated_planes.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "importer/sources/open_source.hpp"
#include "importer/sources/series/series_times.hpp"
#include "importer/step_selection.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wakesurf::importer {

using core::Error;

namespace {

core::Result<void> check_times(const std::vector<double>& times) {
    if (times.empty())
        return core::fail(Error::Code::Corrupt, "the source has no time-steps");
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!std::isfinite(times[i]))
            return core::fail(Error::Code::Corrupt, "the time of time-step " + std::to_string(i) +
                                                        " is not a finite number");
        if (i > 0 && !(times[i - 1] < times[i]))
            return core::fail(Error::Code::Corrupt,
                              "times do not increase: time-step " + std::to_string(i - 1) +
                                  " is at " + std::to_string(times[i - 1]) + ", the next at " +
                                  std::to_string(times[i]));
    }
    return {};
}

struct Times {
    std::vector<double> values;
    std::string note;
};

// Returns the times that the source states, or those of the user if it states none.
core::Result<Times> times_of(const SourceDescription& source, const command::SourceOptions& taken) {
    if (!taken.times() || source.times.empty())
        return Times{source.times, source.time_note};
    if (source.places.empty())
        return core::fail(Error::Code::InvalidArgument,
                          std::string(taken.dt ? "--dt" : "--start") +
                              " is for numbered files that state no times; " + source.name +
                              " has the times " + time_text(source.times.front()) + " to " +
                              time_text(source.times.back()),
                          "leave it out");
    const double start = taken.start.value_or(0.0);
    const double dt = taken.dt.value_or(1.0);
    Times out;
    for (const double place : source.places)
        out.values.push_back(start + dt * place);
    out.note = "times: " + time_text(start) + " and then every " + time_text(dt) +
               ", by --start and --dt, are used";
    if (source.places.back() + 1.0 > static_cast<double>(source.places.size()))
        out.note += "; where numbers of files are missing, so are times";
    return out;
}

// Takes the time-steps of `steps` up to the first that cannot be read, but its files as well: they may be whole
// later.
core::Result<void> take_steps(const std::vector<double>& times,
                              const std::vector<std::size_t>& steps,
                              bool growing,
                              ImportPlan& plan) {
    const Source& source = *plan.source;
    auto shared = source.shared_files();
    if (!shared)
        return tl::unexpected(shared.error());
    plan.made_from.files = std::move(*shared);
    for (const std::size_t step : steps) {
        auto files = source.files(step);
        const auto known = source.description().unreadable.find(step);
        const bool unreadable = !growing && known != source.description().unreadable.end();
        if (files)
            plan.made_from.steps.push_back(std::move(*files));
        if (files && !unreadable) {
            plan.steps.push_back(step);
            plan.times.push_back(times[step]);
            continue;
        }
        const Error& why = unreadable ? known->second : files.error();
        const bool gone = why.code == Error::Code::NotFound; // a piece, as of a run that was killed
        if (plan.steps.empty() || (!gone && !ends_series(why)))
            return tl::unexpected(why);
        plan.end_note = note_on_end(times[step], why);
        break;
    }
    return {};
}

MaskUse mask_use(const command::SourceOptions& taken) {
    return taken.mask == "gap"      ? MaskUse::Gap
           : taken.mask == "scalar" ? MaskUse::Scalar
                                    : MaskUse::Body;
}

// Returns true if a mask of 0 and 1 at first has other values at the last time-step: it is a fraction. A
// time-step that cannot be read is reported when the import reaches it.
bool drops_its_mask(const ImportPlan& plan, FieldWish& wish) {
    if (!plan.choice.mask)
        return false;
    const std::size_t last = plan.steps.size() - 1;
    for (const std::size_t index : {std::size_t{0}, last}) {
        const auto step = plan.source->read(plan.steps[index], {*plan.choice.mask});
        if (step && !is_zero_or_one(step->blocks, *plan.choice.mask)) {
            wish.no_masks.push_back(plan.choice.mask->name);
            return true;
        }
        if (last == 0)
            break;
    }
    return false;
}

} // namespace

std::string ImportPlan::step_name(std::size_t index) const {
    const auto& files = made_from.steps[index];
    const std::string step = "time-step " + std::to_string(index);
    if (!files.empty())
        return files.front().name + " (" + step + ")";
    return step + " of " + source->description().name;
}

core::Result<SourceStep> ImportPlan::read(std::size_t index) const {
    auto step = source->read(steps[index], choice.arrays());
    if (!step)
        return step;
    return even_slabs(step->blocks)
        .and_then([&] { return leave_body_out(step->blocks, choice); })
        .map([&] { return std::move(*step); })
        .map_error([&](Error error) { return about_step(*this, index, std::move(error)); });
}

namespace {

std::size_t place_of(std::size_t step, const std::vector<std::size_t>& steps) {
    return static_cast<std::size_t>(std::ranges::find(steps, step) - steps.begin());
}

constexpr std::size_t most_steps = 1'000'000;

vtkDataArray* values_in(vtkDataSet& data, const core::FieldInfo& field) {
    return field.source == core::FieldInfo::Source::Point
               ? data.GetPointData()->GetArray(field.name.c_str())
               : data.GetCellData()->GetArray(field.name.c_str());
}

// Returns the sum of the squared differences of what the velocity is made of; nothing where the meshes differ.
std::optional<double> difference(const ImportPlan& plan, const SourceStep& a, const SourceStep& b) {
    if (a.blocks.size() != b.blocks.size())
        return std::nullopt;
    double sum = 0.0;
    for (std::size_t block = 0; block < a.blocks.size(); ++block)
        for (const core::FieldInfo& field : plan.choice.velocity.arrays) {
            auto* one = values_in(*a.blocks[block], field);
            auto* other = values_in(*b.blocks[block], field);
            if (one == nullptr || other == nullptr ||
                one->GetNumberOfTuples() != other->GetNumberOfTuples() ||
                one->GetNumberOfComponents() != other->GetNumberOfComponents())
                return std::nullopt;
            for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
                for (int c = 0; c < one->GetNumberOfComponents(); ++c) {
                    const double change = one->GetComponent(i, c) - other->GetComponent(i, c);
                    sum += std::isfinite(change) ? change * change : 0.0;
                }
        }
    return sum;
}

// Says whether the last time-step is the first again: much nearer to it than the second is.
core::Result<bool> comes_back(const ImportPlan& plan) {
    if (plan.steps.size() < 3)
        return false;
    auto first = plan.read(0);
    if (!first)
        return tl::unexpected(first.error());
    std::array<std::optional<double>, 2> apart;
    for (const std::size_t index : {std::size_t{1}, plan.steps.size() - 1}) {
        const auto other = plan.read(index);
        if (!other)
            return tl::unexpected(other.error());
        apart[index == 1 ? 0 : 1] = difference(plan, *first, *other);
    }
    constexpr double near = 0.25;
    return apart[0] && apart[1] && *apart[1] <= near * near * *apart[0];
}

// Repeats the time-steps of one period, --loop, and says so in the note. The last one is left out if it is the
// first again; else the period goes on from it to the first for as long as between the two before, unless its
// length is stated. The series ends with the first time-step once more.
core::Result<void> repeat_period(const command::Loop& loop, ImportPlan& plan) {
    constexpr auto invalid = Error::Code::InvalidArgument;
    if (!plan.end_note.empty())
        return core::fail(invalid, "--loop needs a whole period, but " + plan.end_note,
                          "leave --loop out, or choose whole time-steps with --times");
    std::vector<double>& times = plan.times;
    if (times.size() < 2)
        return core::fail(invalid, "--loop needs two time-steps or more, and there is one",
                          "leave it out");
    const double stored = times.back() - times.front();
    bool back = false;
    if (loop.period) {
        if (!(*loop.period >= stored * (1.0 - 1e-9)))
            return core::fail(invalid,
                              "--loop: a period of " + time_text(*loop.period) +
                                  " is shorter than the stored times, which go on for " +
                                  time_text(stored),
                              "choose those of one period with --times");
        back = *loop.period <= stored * (1.0 + 1e-9);
    } else {
        auto known = comes_back(plan);
        if (!known)
            return tl::unexpected(known.error());
        back = *known;
    }
    const double period = loop.period && !back ? *loop.period
                          : back               ? stored
                                               : stored + times.back() - times[times.size() - 2];
    const std::string stored_text =
        "times " + time_text(times.front()) + " to " + time_text(times.back());
    const std::size_t steps = times.size() - (back ? 1 : 0);
    if (steps > most_steps / loop.periods)
        return core::fail(Error::Code::OverLimit,
                          "--loop: " + std::to_string(loop.periods) + " periods of " +
                              std::to_string(steps) + " time-steps are more than " +
                              std::to_string(most_steps),
                          "repeat it less often");
    plan.period_steps = steps;
    const std::vector<double> once(times.begin(), times.end());
    const auto files = plan.made_from.steps;
    const std::vector<std::size_t> places(plan.steps.begin(), plan.steps.end());
    times.clear();
    plan.steps.clear();
    plan.made_from.steps.clear();
    for (std::size_t i = 0; i <= loop.periods * steps; ++i) {
        times.push_back(once[i % steps] + static_cast<double>(i / steps) * period);
        plan.steps.push_back(places[i % steps]);
        plan.made_from.steps.push_back(files[i % steps]);
    }
    add_note(plan.time_note, "the " + stored_text + " are one period of " + time_text(period) +
                                 ", repeated " + std::to_string(loop.periods) + " times by --loop" +
                                 (back          ? ": the last time-step is the first again"
                                  : loop.period ? ""
                                                : ": from the last time-step to the first again "
                                                  "as long as between the two before"));
    return {};
}

} // namespace

std::string note_on_end(double time, const Error& why) {
    return "the data end before time " + time_text(time) + ": " + why.message +
           (why.hint.empty() ? "" : " (" + why.hint + ")");
}

core::Result<ImportPlan> make_plan(const ImportRequest& request, const UnclearVelocity& unclear) {
    return open_source(request.source, request.taken).and_then([&](std::unique_ptr<Source> source) {
        return plan_of(std::move(source), request, unclear);
    });
}

core::Result<ImportPlan> plan_of(std::unique_ptr<Source> source,
                                 const ImportRequest& request,
                                 const UnclearVelocity& unclear) {
    const SourceDescription& description = source->description();
    auto times = times_of(description, request.taken);
    if (!times)
        return tl::unexpected(times.error());
    if (auto sound = check_times(times->values); !sound)
        return core::fail(sound.error().code, description.name + ": " + sound.error().message,
                          sound.error().hint);
    auto steps = select_times(times->values, request.times);
    if (!steps)
        return tl::unexpected(steps.error());
    auto settled = settle_fields(*source, *steps, times->values, request.taken.velocity);
    if (!settled)
        return tl::unexpected(settled.error());
    ImportPlan plan;
    plan.source = std::move(source);
    plan.described = settled->described;
    plan.fields = std::move(settled->fields);
    if (auto taken = take_steps(times->values, settled->steps, request.growing, plan); !taken)
        return tl::unexpected(taken.error());
    plan.made_from.selection = request.selection;
    plan.precision = request.precision;
    plan.placement = request.placement;
    plan.jobs = request.jobs;
    plan.memory = request.memory;
    plan.time_note = std::move(times->note);
    add_note(plan.time_note, settled->note);
    const auto& fields = plan.fields;
    const auto& stated = plan.source->description().velocities;
    FieldWish wish{request.fields, request.taken.velocity, {}, stated, mask_use(request.taken)};
    const bool first_phase = wish.velocity.empty() && !plan.source->description().velocity.empty();
    if (first_phase)
        wish.velocity = plan.source->description().velocity;
    do {
        auto choice = choose_fields(fields, wish);
        if (!choice && unclear && !choose_velocity(fields, wish.velocity, stated))
            unclear(velocity_candidates(fields, stated));
        if (!choice)
            return core::fail(
                choice.error().code,
                (settled->none && plan.steps.size() > 1 ? "no time-step has the velocity: " : "") +
                    plan.step_name(place_of(plan.described, plan.steps)) + ": " +
                    choice.error().message,
                choice.error().hint);
        plan.choice = std::move(*choice);
    } while (drops_its_mask(plan, wish));
    if (first_phase)
        plan.choice.why =
            "the velocity of the first phase; its cell values are averaged to the points";
    plan.demanded = request.taken.periodic;
    if (core::any(plan.demanded)) {
        const auto note = add_repeated_planes(plan.source, plan.steps, plan.choice, plan.demanded,
                                              plan.step_name(0));
        if (!note)
            return tl::unexpected(note.error());
        add_note(plan.time_note, *note);
    }
    if (request.taken.loop)
        if (auto repeated = repeat_period(*request.taken.loop, plan); !repeated)
            return tl::unexpected(repeated.error());
    progress_marks().surveyed = true;
    return plan;
}

Error about_step(const ImportPlan& plan, std::size_t index, Error error) {
    error.message = plan.step_name(index) + " " + error.message;
    return error;
}

} // namespace wakesurf::importer
