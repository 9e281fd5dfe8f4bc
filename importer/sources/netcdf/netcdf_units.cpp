#include "importer/sources/netcdf/netcdf_units.hpp"

#include "importer/base/text.hpp"
#include "importer/fields/physical_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string out;
    for (const auto& name : names)
        out += (out.empty() ? "" : ", ") + name;
    return out;
}

// Is true of calendars with the usual days; a model year of 360 or 365 days has other dates.
bool is_usual_calendar(const std::string& calendar) {
    constexpr std::array<std::string_view, 4> usual{"", "standard", "gregorian",
                                                    "proleptic_gregorian"};
    return std::find(usual.begin(), usual.end(), calendar) != usual.end();
}

core::Result<double> shift_of(const NetcdfFile& file,
                              const NetcdfVariable& time,
                              const std::string& first,
                              const std::string& here) {
    if (first.empty() || first == here)
        return 0.0;
    const std::string calendar = file.text(time, "calendar");
    if (const auto seconds = seconds_between(first, here); seconds && is_usual_calendar(calendar))
        return *seconds;
    return core::fail(Error::Code::Unsupported,
                      file.name() + " counts its times since " + here + ", the first file since " +
                          first + (calendar.empty() ? "" : ", in the calendar " + calendar),
                      "write all files with one reference time");
}

using Groups = std::map<std::string, std::vector<std::string>>; ///< names by the unit they state

void note_converted(std::string& note, const Groups& groups, const std::string& to) {
    for (const auto& [from, names] : groups)
        add_note(note, listed(names) + (names.size() == 1 ? " was" : " were") + " converted from " +
                           from + " to " + to);
}

void note_unconverted(std::string& note, const Groups& groups, const std::string& as) {
    for (const auto& [unit, names] : groups)
        add_note(note, listed(names) +
                           (unit.empty()
                                ? std::string(names.size() == 1 ? " has" : " have") + " no unit: "
                                : (names.size() == 1 ? " is" : " are") +
                                      (" in '" + unit + "', which is not known: ")) +
                           "kept, and taken as " + as);
}

} // namespace

core::Result<NetcdfTimes> read_times(const NetcdfFile& file,
                                     const NetcdfVariable& time,
                                     const std::string& reference,
                                     bool several) {
    auto values = file.read(time);
    if (!values)
        return tl::unexpected(values.error());
    if (auto known = check_units_known(); !known)
        return tl::unexpected(known.error());
    const std::string text = file.text(time, "units");
    const auto [unit, since] = split_reference(text);
    NetcdfTimes out{std::move(*values), since, unit, {}};
    const auto factor = factor_to_si(unit, Quantity::Time);
    if ((several || out.seconds.size() > 1) && varies_in_length(unit))
        return core::fail(Error::Code::Unsupported,
                          file.name() + " counts its times in " + unit +
                              ", which are not all of one length",
                          "write them in days, hours or seconds");
    auto shift = shift_of(file, time, reference, since);
    if (!shift)
        return tl::unexpected(shift.error());
    for (double& value : out.seconds)
        value = value * factor.value_or(1.0) + *shift;
    const std::string from = since.empty() ? "" : " since " + since;
    if (!text.empty() && !factor)
        out.note = "times are in '" + text + "', which is not known: kept, and taken as s";
    else if (!text.empty() && *factor == 1.0)
        out.note = "times are in " + text;
    else if (factor)
        out.note = "times were converted from " + unit + " to seconds" + from;
    return out;
}

namespace {

// Makes "2020-01-01 00:00:00" of "2020-01-01_00:00:00" and "2020-01-01T00:00:00Z", as UDUNITS reads it.
std::string usual_date(std::string text) {
    for (char& c : text)
        if (c == '_' || c == 'T')
            c = ' ';
    std::erase(text, 'Z');
    return text;
}

bool is_date(const std::string& text) {
    return seconds_between(usual_date(text), usual_date(text)).has_value();
}

// Returns the dates of the time-steps, as the file writes them, and where they are.
std::pair<std::vector<std::string>, std::string> dates_of(const NetcdfFile& file,
                                                          std::size_t steps) {
    for (const auto& variable : file.variables())
        if (const auto name = lower_case(last_of_path(variable.name));
            !has_numbers(variable) && (name == "time" || name == "times"))
            if (auto texts = file.texts(variable);
                texts.size() == steps && std::ranges::all_of(texts, is_date))
                return {std::move(texts), variable.name};
    for (const char* const name : {"time", "Time", "start_time", "time_coverage_start"})
        if (auto text = file.text(file.whole(), name); steps == 1 && is_date(text))
            return {{std::move(text)}, name};
    return {};
}

} // namespace

std::optional<NetcdfTimes>
read_other_times(const NetcdfFile& file, std::size_t steps, const std::string& reference) {
    for (const char* const name : {"time", "Time", "TIME", "simulation_time"})
        if (auto value = file.numbers(file.whole(), name);
            steps == 1 && value.size() == 1 && std::isfinite(value.front()))
            return NetcdfTimes{std::move(value), "", "",
                               std::string("times are the attribute ") + name};
    if (!check_units_known())
        return std::nullopt;
    const auto [dates, where] = dates_of(file, steps);
    if (dates.empty())
        return std::nullopt;
    NetcdfTimes out{{}, reference.empty() ? usual_date(dates.front()) : reference, "s", {}};
    for (const auto& date : dates) {
        const auto seconds = seconds_between(out.reference, usual_date(date));
        if (!seconds || !std::isfinite(*seconds))
            return std::nullopt;
        out.seconds.push_back(*seconds);
    }
    out.note = "times are seconds since " + out.reference + ", from the dates in " + where;
    return out;
}

NetcdfUnit unit_of(const NetcdfFile& file, const NetcdfVariable& variable) {
    const std::string text = file.text(variable, "units");
    for (const auto quantity : {Quantity::Velocity, Quantity::Momentum, Quantity::Density})
        if (const auto factor = factor_to_si(text, quantity))
            return {*factor, si_unit(quantity)};
    return {1.0, text};
}

std::string note_on_units(const NetcdfFile& file,
                          const NetcdfGrid& grid,
                          const std::vector<std::string>& velocity,
                          const std::optional<std::string>& times) {
    std::string note;
    Groups converted;
    Groups unconverted;
    bool stated = times && factor_to_si(*times, Quantity::Time);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& axis = grid.axes[i];
        stated = stated || axis.known;
        if (axis.factor != 1.0)
            converted[axis.units].emplace_back(1, "xyz"[i]);
        if (!axis.known)
            unconverted[axis.units].emplace_back(1, "xyz"[i]);
    }
    Groups unconverted_velocity;
    for (const auto& name : velocity) {
        const auto* variable = file.variable(name);
        const std::string text = variable == nullptr ? "" : file.text(*variable, "units");
        const bool known = factor_to_si(text, Quantity::Velocity).has_value() ||
                           factor_to_si(text, Quantity::Momentum).has_value();
        stated = stated || known;
        if (!known)
            unconverted_velocity[text].push_back(name);
    }
    note_converted(note, converted, "m");
    std::map<std::string, Groups> values;
    for (const auto& [name, components] : grid.variables) {
        const auto& variable = *file.variable(name);
        if (const auto unit = unit_of(file, variable); unit.factor != 1.0)
            values[unit.unit][file.text(variable, "units")].push_back(name);
    }
    for (const auto& [unit, groups] : values)
        note_converted(note, groups, unit);
    // If nothing states a unit, numbers have no dimensions, and none is wrong.
    if (!stated) {
        std::erase_if(unconverted, [](const auto& group) { return group.first.empty(); });
        std::erase_if(unconverted_velocity, [](const auto& group) { return group.first.empty(); });
    }
    if (stated && times && times->empty())
        add_note(note, "the times have no unit: kept, and taken as s");
    note_unconverted(note, unconverted, "m");
    note_unconverted(note, unconverted_velocity, "m s-1");
    return note;
}

} // namespace wakesurf::importer
