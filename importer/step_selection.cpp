#include "importer/step_selection.hpp"

#include "core/base/rounding.hpp"
#include "importer/base/text.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/series/series_times.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

std::optional<TimeSelection> parse_range(std::string_view text) {
    std::vector<double> parts;
    for (std::string_view rest = text;;) {
        const auto colon = rest.find(':');
        const auto part = finite_number(rest.substr(0, colon));
        if (!part)
            return std::nullopt;
        parts.push_back(*part);
        if (colon == std::string_view::npos)
            break;
        rest.remove_prefix(colon + 1);
    }
    if (parts.size() == 2)
        parts.push_back(1.0);
    if (parts.size() != 3 || parts[1] < parts[0] || parts[2] < 1 || parts[2] > 1e9 ||
        parts[2] != std::floor(parts[2]))
        return std::nullopt;
    return TimeSelection{parts[0], parts[1], static_cast<std::size_t>(parts[2])};
}

} // namespace

core::Result<std::vector<TimeSelection>> parse_times(const std::string& text) {
    std::vector<TimeSelection> out;
    for (std::string_view rest = text;;) {
        const auto comma = rest.find(',');
        const auto range = parse_range(rest.substr(0, comma));
        if (!range)
            return core::fail(Error::Code::InvalidArgument,
                              "--times " + text +
                                  " is not T0:T1 or T0:T1:EVERY, or several of them with commas",
                              "for example --times 8.5:16:2");
        out.push_back(*range);
        if (comma == std::string_view::npos)
            return out;
        rest.remove_prefix(comma + 1);
    }
}

core::Result<std::vector<std::size_t>> select_times(std::span<const double> times,
                                                    const std::vector<TimeSelection>& ranges) {
    std::vector<std::size_t> chosen;
    std::vector<std::size_t> within(ranges.size(), 0);
    for (std::size_t i = 0; i < times.size(); ++i) {
        bool wanted = ranges.empty();
        for (std::size_t r = 0; r < ranges.size(); ++r) {
            const auto& [from, to, every] = ranges[r];
            if (core::within_rounding(times[i], from, to))
                wanted = within[r]++ % every == 0 || wanted;
        }
        if (wanted)
            chosen.push_back(i);
    }
    if (chosen.empty())
        return core::fail(Error::Code::OutOfTime, "no time-step lies in --times; there is " +
                                                      std::to_string(times.front()) + " to " +
                                                      std::to_string(times.back()));
    return chosen;
}

namespace {

using Fields = std::vector<FieldInfo>;

enum class Velocity { None, Doubtful, Clear };

// Several that could be meant are clear: it is asked which.
Velocity velocity_among(const Fields& fields,
                        const std::string& wish,
                        const std::vector<StatedComponents>& stated) {
    const auto velocity = choose_velocity(fields, wish, stated);
    if (!velocity)
        return velocity.error().code == Error::Code::NotFound ? Velocity::None : Velocity::Clear;
    return velocity->doubt.empty() ? Velocity::Clear : Velocity::Doubtful;
}

struct Found {
    std::optional<std::size_t> step; ///< the first with a velocity
    bool all_read = true;            ///< no time-step that was read for it is damaged
};

// Describes the source by its first time-step with a velocity, but one whose name is clear goes before others;
// by the first of all if there is none, or if a time-step before it cannot be read.
core::Result<Found>
describe_by_first(Source& source, const std::vector<std::size_t>& steps, const std::string& wish) {
    const auto& now = source.description();
    Found out;
    bool doubtful = true;
    for (const auto least : {Velocity::Clear, Velocity::Doubtful}) {
        if (!std::exchange(doubtful, false))
            break;
        for (const std::size_t step : steps) {
            const auto listed = source.fields_at(step);
            const auto by_list = velocity_among(listed.value_or(Fields()), wish, now.velocities);
            doubtful = doubtful || by_list == Velocity::Doubtful;
            if (listed && by_list < least)
                continue;
            auto described = source.describe_by(step);
            if (!described && step == steps.front())
                return tl::unexpected(described.error());
            out.all_read = described.has_value();
            if (!described)
                break;
            const auto found = velocity_among(now.fields, wish, now.velocities);
            if (found >= least || (!listed && found != Velocity::None)) {
                out.step = step;
                return out;
            }
        }
    }
    return source.describe_by(steps.front()).map([&] { return out; });
}

std::string listed_times(const std::vector<std::size_t>& steps, const std::vector<double>& times) {
    constexpr std::size_t most = 5;
    std::string out = steps.size() == 1 ? "time " : "times ";
    for (std::size_t i = 0; i < std::min(most, steps.size()); ++i)
        out += (i == 0 ? "" : ", ") + time_text(times.at(steps[i]));
    return out + (steps.size() > most ? ", ... (" + std::to_string(steps.size()) + " in all)" : "");
}

bool is_here(const Fields& fields, const FieldInfo& field) {
    return std::ranges::any_of(fields, [&](const FieldInfo& other) {
        return other.name == field.name && other.source == field.source;
    });
}

std::string joined(const std::set<std::string>& names) {
    std::string out;
    for (const auto& name : names)
        out += (out.empty() ? "" : ", ") + name;
    return out;
}

} // namespace

core::Result<StepFields> settle_fields(Source& source,
                                       const std::vector<std::size_t>& steps,
                                       const std::vector<double>& times,
                                       const std::string& wish) {
    const auto first = describe_by_first(source, steps, wish);
    if (!first)
        return tl::unexpected(first.error());
    const auto& now = source.description();
    StepFields out{
        steps, first->step.value_or(steps.front()), !first->step && first->all_read, {}, {}};
    // What is refused is told of a time-step that has another velocity, if there is one.
    if (out.none && !wish.empty())
        if (const auto other = describe_by_first(source, steps, {}); other)
            out.described = other->step.value_or(steps.front());
    out.fields = now.fields;
    if (!first->step)
        return out;
    const auto velocity = possible_velocity(now.fields, wish, now.velocities);
    const auto lacks_velocity = [&](const Fields& fields) {
        return std::ranges::any_of(velocity, [&](const std::string& name) {
            return std::ranges::find(fields, name, &FieldInfo::name) == fields.end();
        });
    };
    out.steps.clear();
    std::map<std::string, std::vector<std::size_t>> bare; // by the velocity that they have instead
    std::set<std::string> not_everywhere;
    const auto of_first = source.fields_at(*first->step);
    for (const std::size_t step : steps) {
        const auto listed = step == *first->step ? std::nullopt : source.fields_at(step);
        if (listed ? lacks_velocity(*listed) : step < *first->step) {
            const auto other = choose_velocity(listed.value_or(Fields()), {}, now.velocities);
            bare[other ? other->name : ""].push_back(step);
            continue;
        }
        out.steps.push_back(step);
        if (!listed)
            continue;
        for (const auto& field : *listed)
            if (of_first && !is_here(*of_first, field))
                not_everywhere.insert(field.name);
        std::erase_if(out.fields, [&](const FieldInfo& field) {
            const bool gone = !velocity.contains(field.name) && !is_here(*listed, field);
            if (gone)
                not_everywhere.insert(field.name);
            return gone;
        });
    }
    for (const auto& [other, without] : bare)
        add_note(out.note, "left out, as there is no " +
                               (velocity.empty() ? "velocity" : joined(velocity)) + ": " +
                               listed_times(without, times) +
                               (other.empty() ? "" : " (with " + other + ": --velocity)"));
    if (!not_everywhere.empty())
        add_note(out.note, "not at every time-step: " + joined(not_everywhere));
    return out;
}

} // namespace wakesurf::importer
