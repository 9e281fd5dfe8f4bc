#include "server/import/sources/series/series_times.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace wakesurf::server {

using core::Error;

std::string time_text(double time) {
    std::array<char, 40> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), time);
    return {text.data(), end};
}

namespace {

// A time between those of the readable neighbours; at the end of the series one further step as long as the last.
void make_up_times(std::vector<TimedEntry>& entries) {
    for (std::size_t i = 1; i < entries.size(); ++i) {
        if (!entries[i].unreadable || !entries[i - 1].time)
            continue;
        const double before = *entries[i - 1].time;
        const auto next =
            std::find_if(entries.begin() + static_cast<std::ptrdiff_t>(i), entries.end(),
                         [](const TimedEntry& e) { return e.time.has_value(); });
        if (next != entries.end())
            entries[i].time = 0.5 * (before + *next->time);
        else
            entries[i].time = before + (i > 1 ? before - *entries[i - 2].time : 1.0);
    }
}

} // namespace

std::vector<double> places_of(const std::vector<TimedEntry>& entries) {
    double step = 0.0;
    bool numbered = true;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        numbered = numbered && entries[i].number.has_value();
        if (numbered && i > 0) {
            const double difference = *entries[i].number - *entries[i - 1].number;
            step = i == 1 ? difference : std::min(step, difference);
        }
    }
    std::vector<double> out;
    for (std::size_t i = 0; i < entries.size(); ++i)
        out.push_back(numbered && step > 0.0 ? (*entries[i].number - *entries[0].number) / step
                                             : static_cast<double>(i));
    return out;
}

core::Result<SeriesTimes> settle_times(std::vector<TimedEntry> entries) {
    SeriesTimes out;
    const auto is_timed = [](const TimedEntry& e) { return e.time.has_value(); };
    make_up_times(entries);
    const auto timed = std::find_if(entries.begin(), entries.end(), is_timed);
    if (timed == entries.end()) {
        for (std::size_t i = 0; i < entries.size(); ++i)
            out.times.push_back(static_cast<double>(i));
        out.places = places_of(entries);
        if (entries.size() > 1)
            out.note = "the files carry no times: 0, 1, 2, ... are used";
        return out;
    }
    const auto untimed = std::find_if_not(entries.begin(), entries.end(), is_timed);
    if (untimed != entries.end())
        return core::fail(Error::Code::Corrupt,
                          timed->name + " has a time, but " + untimed->name + " has none",
                          "write a .pvd that gives every file its time");
    for (std::size_t i = 0; i < entries.size(); ++i) {
        out.times.push_back(*entries[i].time);
        if (i == 0 || out.times[i - 1] < out.times[i])
            continue;
        const std::string both = entries[i - 1].name + " and " + entries[i].name;
        if (out.times[i - 1] == out.times[i])
            return core::fail(Error::Code::Corrupt,
                              both + " have the same time, " + time_text(out.times[i]),
                              "keep one of them, or write a .pvd that gives every file its time");
        return core::fail(Error::Code::Corrupt,
                          entries[i].name + " comes after " + entries[i - 1].name +
                              " but has an earlier time: " + time_text(out.times[i]) + " after " +
                              time_text(out.times[i - 1]),
                          "write a .pvd that gives every file its time");
    }
    return out;
}

} // namespace wakesurf::server
