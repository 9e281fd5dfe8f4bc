#include "importer/repeated_period.hpp"

#include "importer/base/notes.hpp"
#include "importer/sources/series/series_times.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <optional>

namespace wakesurf::importer {

using core::Error;

namespace {

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

} // namespace

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

} // namespace wakesurf::importer
