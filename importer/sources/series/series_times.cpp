#include "importer/sources/series/series_times.hpp"

#include "importer/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace wakesurf::importer {

using core::Error;

std::string time_text(double time) {
    std::array<char, 40> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), time);
    return {text.data(), end};
}

namespace {

// Inserts times between those of the readable neighbours; at the end of the series one further step as long
// as the last.
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

// Sorts by time; entries of one time keep their order.
std::vector<std::size_t> by_time(const std::vector<TimedEntry>& entries) {
    std::vector<std::size_t> out(entries.size());
    std::iota(out.begin(), out.end(), std::size_t{0});
    std::stable_sort(out.begin(), out.end(),
                     [&](auto a, auto b) { return *entries[a].time < *entries[b].time; });
    return out;
}

std::string note_on_backward_times(const std::vector<TimedEntry>& entries) {
    for (std::size_t i = 1; i < entries.size(); ++i)
        if (*entries[i].time < *entries[i - 1].time)
            return "times go back at " + entries[i].name + ", as after a restart: they are sorted";
    return {};
}

std::string note_on_made_up_times(const std::vector<TimedEntry>& entries) {
    const bool cycles = std::all_of(entries.begin(), entries.end(),
                                    [](const TimedEntry& e) { return e.cycle.has_value(); });
    return std::string("the files carry ") + (cycles ? "cycles, but " : "") +
           "no times: 0, 1, 2, ... are used";
}

} // namespace

bool same_time(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

std::string written_again(const std::vector<std::string>& left_out) {
    constexpr std::size_t most = 8;
    std::string out;
    for (std::size_t i = 0; i < std::min(most, left_out.size()); ++i)
        out += (i == 0 ? "left out, as another was written later for the same time: " : ", ") +
               left_out[i];
    return out +
           (left_out.size() > most ? ", ... (" + std::to_string(left_out.size()) + " in all)" : "");
}

std::vector<double> places_of(const std::vector<TimedEntry>& entries) {
    std::vector<double> numbers;
    for (const auto& each : entries)
        if (const auto number = each.cycle ? each.cycle : each.number)
            numbers.push_back(*number);
    double step = numbers.size() > 1 ? numbers[1] - numbers[0] : 0.0;
    for (std::size_t i = 1; i < numbers.size(); ++i)
        step = std::min(step, numbers[i] - numbers[i - 1]);
    std::vector<double> out;
    for (std::size_t i = 0; i < entries.size(); ++i)
        out.push_back(numbers.size() == entries.size() && step > 0.0
                          ? (numbers[i] - numbers[0]) / step
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
        out.order.resize(entries.size());
        std::iota(out.order.begin(), out.order.end(), std::size_t{0});
        if (entries.size() > 1)
            out.note = note_on_made_up_times(entries);
        return out;
    }
    const auto untimed = std::find_if_not(entries.begin(), entries.end(), is_timed);
    if (untimed != entries.end())
        return core::fail(Error::Code::Corrupt,
                          timed->name + " has a time, but " + untimed->name + " has none",
                          "write a .pvd that gives every file its time");
    std::vector<std::string> left_out;
    for (const std::size_t i : by_time(entries)) {
        if (!out.times.empty() && same_time(out.times.back(), *entries[i].time)) {
            left_out.push_back(entries[out.order.back()].name);
            out.times.pop_back();
            out.order.pop_back();
        }
        out.times.push_back(*entries[i].time);
        out.order.push_back(i);
    }
    out.note = note_on_backward_times(entries);
    add_note(out.note, written_again(left_out));
    if (std::any_of(entries.begin(), entries.end(), [](const auto& e) { return e.in_title; })) {
        add_note(out.note, "the times are those in the titles of the files");
        std::vector<TimedEntry> kept;
        for (const std::size_t i : out.order)
            kept.push_back(entries[i]);
        out.places = places_of(kept);
    }
    return out;
}

core::Result<std::vector<std::size_t>> describe_times(std::vector<TimedEntry> entries,
                                                      SourceDescription& description) {
    return settle_times(entries).map([&](SeriesTimes settled) {
        for (std::size_t i = 0; i < settled.order.size(); ++i)
            if (const auto& why = entries[settled.order[i]].unreadable)
                description.unreadable.emplace(i, *why);
        description.times = std::move(settled.times);
        description.time_note = std::move(settled.note);
        description.places = std::move(settled.places);
        return std::move(settled.order);
    });
}

} // namespace wakesurf::importer
