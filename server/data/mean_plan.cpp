#include "server/data/mean_plan.hpp"

#include "server/base/field_names.hpp"
#include "server/remote/remote_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;
using core::TimeMeans;

namespace {

constexpr std::size_t most_usual_phases = 24;

template <std::size_t Component>
double mean_of(const TimeMeans& means, std::size_t place) {
    return means.mean(place, Component);
}

template <std::size_t Component>
double rms_of(const TimeMeans& means, std::size_t place) {
    return std::sqrt(means.variance(place, Component));
}

double magnitude(const TimeMeans& means, std::size_t place) {
    return std::hypot(means.mean(place, 0), means.mean(place, 1), means.mean(place, 2));
}

double variances(const TimeMeans& means, std::size_t place) {
    return means.variance(place, 0) + means.variance(place, 1) + means.variance(place, 2);
}

double whole_rms(const TimeMeans& means, std::size_t place) {
    return std::sqrt(variances(means, place));
}

double energy(const TimeMeans& means, std::size_t place) {
    return 0.5 * variances(means, place);
}

std::vector<MeanOutput> outputs_of(bool vector, bool phases) {
    if (phases && vector)
        return {{"_phase", magnitude},
                {"_phase_x", mean_of<0>},
                {"_phase_y", mean_of<1>},
                {"_phase_z", mean_of<2>}};
    if (phases)
        return {{"_phase", mean_of<0>}};
    if (vector)
        return {{"_mean", magnitude},    {"_mean_x", mean_of<0>}, {"_mean_y", mean_of<1>},
                {"_mean_z", mean_of<2>}, {"_rms", whole_rms},     {"_rms_x", rms_of<0>},
                {"_rms_y", rms_of<1>},   {"_rms_z", rms_of<2>},   {core::energy_suffix, energy}};
    return {{"_mean", mean_of<0>}, {"_rms", rms_of<0>}};
}

/// Returns a phase that no time-step falls into.
std::optional<std::size_t> empty_phase(const MeanPlan& plan, const std::vector<double>& times) {
    for (std::size_t phase = 0; phase < plan.record.phases; ++phase)
        if (plan.steps_in(phase, times).empty())
            return phase;
    return std::nullopt;
}

Result<void> choose_phases(MeanPlan& plan, const MeanWish& wish, const std::vector<double>& times) {
    if (!wish.period)
        return wish.phases ? fail(Error::Code::InvalidArgument, "`phases` are those of a `period`",
                                  "name the period, too")
                           : Result<void>();
    core::MeanRecord& record = plan.record;
    record.period = *wish.period;
    if (record.period > record.to - record.from)
        return fail(Error::Code::InvalidArgument,
                    fmt::format("the period {:g} is longer than the time that is averaged, {:g}",
                                record.period, record.to - record.from));
    const double spacing = (record.to - record.from) / static_cast<double>(plan.steps.size() - 1);
    record.phases = wish.phases.value_or(static_cast<std::size_t>(
        std::clamp(std::round(record.period / spacing), 2.0, double{most_usual_phases})));
    while (!wish.phases && record.phases > 2 && empty_phase(plan, times))
        --record.phases;
    if (const auto empty = empty_phase(plan, times))
        return fail(Error::Code::InvalidArgument,
                    fmt::format("no time-step falls into phase {} of {}", *empty, record.phases),
                    "choose fewer `phases`");
    return {};
}

Result<void> choose_steps(MeanPlan& plan, const LoadedDataset& dataset, const MeanWish& wish) {
    const std::vector<double>& times = dataset.store->times();
    constexpr double endless = std::numeric_limits<double>::infinity();
    plan.steps =
        store::steps_between(times, wish.from.value_or(-endless), wish.to.value_or(endless));
    const std::size_t ready = steps_ready(dataset);
    std::erase_if(plan.steps, [ready](std::size_t step) { return step >= ready; });
    if (plan.steps.size() < 2)
        return fail(
            Error::Code::OutOfTime,
            fmt::format("there are fewer than two time-steps from {:g} to {:g}: a mean needs "
                        "two",
                        wish.from.value_or(times.front()), wish.to.value_or(times.back())),
            fmt::format("the data are from {:g} to {:g}", times.front(),
                        times[std::max<std::size_t>(1, ready) - 1]));
    std::vector<double> used;
    for (const std::size_t step : plan.steps)
        used.push_back(times[step]);
    plan.weights = core::trapezoidal_weights(used);
    plan.record.from = used.front();
    plan.record.to = used.back();
    plan.record.steps = used.size();
    return choose_phases(plan, wish, times);
}

Result<void> choose_source(MeanPlan& plan, const LoadedDataset& dataset, const std::string& name) {
    const auto field = find_node_field(name, dataset.info, dataset.scalars.get());
    if (!field) {
        std::vector<std::string> imported;
        for (const store::StoredScalar& each : dataset.store->layout().scalars)
            imported.push_back(each.name);
        Error error = no_such_field("fields", name,
                                    node_field_names(std::move(imported), dataset.info.velocity),
                                    dataset.info.fields);
        error.code = Error::Code::InvalidArgument;
        return tl::unexpected(std::move(error));
    }
    plan.source = *field;
    if (field->source == NodeField::Source::Scalar) {
        if (field->index >= dataset.store->layout().scalars.size())
            return fail(Error::Code::InvalidArgument,
                        name + " was made here: means are made of the fields of the data, and of "
                               "what is derived from them");
        plan.column = 1 + field->index;
    }
    const bool derived = field->source == NodeField::Source::Gradient ||
                         field->source == NodeField::Source::VelocityComponent;
    if (derived && (dataset.store->bricks() != nullptr || !dataset.levels))
        return fail(Error::Code::Unsupported,
                    "means of derived fields are not made of data in bricks, nor of axisymmetric "
                    "ones",
                    "the velocity and stored scalars have means");
    return {};
}

Result<MeanPlan>
plan_of(const LoadedDataset& dataset, const MeanWish& wish, const std::string& name) {
    MeanPlan plan{{name, wish.label, 0.0, 0.0, 0, 0.0, 0, WAKESURF_VERSION, {}}, {}};
    return choose_source(plan, dataset, name)
        .and_then([&] { return choose_steps(plan, dataset, wish); })
        .map([&] {
            plan.outputs = outputs_of(plan.components() == 3, plan.record.phases != 0);
            // Components are those in the half plane that the data are of, which turns with the place.
            if (const auto* mesh = std::get_if<core::CellMesh>(&dataset.store->grid());
                mesh != nullptr && mesh->axis)
                std::erase_if(plan.outputs, [](const MeanOutput& each) {
                    const std::string_view suffix = each.suffix;
                    return suffix.ends_with("_x") || suffix.ends_with("_y") ||
                           suffix.ends_with("_z");
                });
            for (const MeanOutput& each : plan.outputs)
                plan.record.fields.push_back(
                    {name + each.suffix + (wish.label.empty() ? "" : "_" + wish.label), {}});
            return std::move(plan);
        });
}

Error used_name(const std::string& name) {
    return {Error::Code::InvalidArgument, "the dataset has a field " + name + " already",
            "choose another `label`, or remove the mean of that name"};
}

Result<void> check_names(const LoadedDataset& dataset, const MeanPlan& plan) {
    auto others = dataset.info.fields;
    std::erase_if(others, [](const core::FieldInfo& each) { return each.mean; });
    for (const core::MeanField& each : plan.record.fields)
        if (is_taken(each.name, dataset.info.velocity, others))
            return tl::unexpected(used_name(each.name));
    return {};
}

} // namespace

Result<void> check_kept_here(const LoadedDataset& dataset) {
    if (!dataset.store)
        return fail(Error::Code::Unsupported, "a built-in flow has no stored time-steps to average",
                    "wakesurf generate writes it to a store, which has");
    if (is_others(dataset.store->layout().folder))
        return fail(Error::Code::Unsupported,
                    "means are stored beside the data, and nothing is written to the web or into a "
                    "Zarr",
                    "make them of a store in a folder");
    return {};
}

Result<std::vector<MeanPlan>> plan_means(const LoadedDataset& dataset, const MeanWish& wish) {
    if (auto here = check_kept_here(dataset); !here)
        return tl::unexpected(here.error());
    if (dataset.store->times().size() < 2)
        return fail(Error::Code::Unsupported,
                    "the dataset has one time-step only, so there is nothing to average");
    const bool plain = std::ranges::all_of(wish.label, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-' || c == '.';
    });
    if (!plain)
        return fail(Error::Code::InvalidArgument, "`label` must be letters, digits, or _ - .",
                    "for example late");
    std::vector<MeanPlan> plans;
    for (const std::string& name : wish.fields) {
        auto plan = plan_of(dataset, wish, name);
        if (!plan)
            return tl::unexpected(plan.error());
        if (auto free = check_names(dataset, *plan); !free)
            return tl::unexpected(free.error());
        if (std::ranges::none_of(
                plans, [&](const MeanPlan& each) { return each.record.of == plan->record.of; }))
            plans.push_back(std::move(*plan));
    }
    return plans;
}

} // namespace wakesurf::server
