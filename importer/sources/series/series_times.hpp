// The times of a series' time-steps, once everything known about them is collected.
#pragma once

#include "importer/base/source.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Holds the time that a file states.
struct StatedTime {
    std::optional<double> time;
    std::optional<double> cycle; ///< of the solver, where it counts them
    bool in_title = false;       ///< the time is in words for people: "data at time= 0.1"
};

struct TimedEntry {
    std::string name; ///< its name in messages
    std::optional<double> time;
    /// Why it cannot be read, if so: its time is unknown, and one is made up between its neighbours'.
    std::optional<core::Error> unreadable{};
    std::optional<double> number{}; ///< in the name of its file
    std::optional<double> cycle{};
    bool in_title = false; ///< as in StatedTime
};

struct SeriesTimes {
    std::vector<double> times; ///< strictly increasing
    std::string note;
    std::vector<double> places;     ///< as in SourceDescription
    std::vector<std::size_t> order; ///< the entry of each time
};

/// Says whether two times differ by roundings of a double only.
bool same_time(double a, double b);

/// Returns the note on files that a restart wrote again: "left out, as ... later ...: a.vti, b.vti". Empty
/// without names.
std::string written_again(const std::vector<std::string>& left_out);

/// Returns the place of each entry in a series without times: 0, 1, 2, but further apart where cycles or
/// numbers between theirs are missing: the smallest difference counts as one.
std::vector<double> places_of(const std::vector<TimedEntry>& entries);

/// Returns the entries' own times, rising; 0, 1, 2, ... with a note if no entry of several has one. Of two
/// entries for one time the later one stays, as after a restart, and a note names the other. Times of titles
/// may be replaced by --dt. Error: Corrupt, naming two entries, if only some have a time.
core::Result<SeriesTimes> settle_times(std::vector<TimedEntry> entries);

/// Writes times, places, note and what cannot be read, as settle_times returns them, into `description`. Returns the entry of each
/// time. Error: as settle_times.
core::Result<std::vector<std::size_t>> describe_times(std::vector<TimedEntry> entries,
                                                      SourceDescription& description);

/// Keeps of `items` those that `order` names, in its order.
template <class Item>
void keep_in_order(std::vector<Item>& items, const std::vector<std::size_t>& order) {
    std::vector<Item> kept;
    for (const std::size_t i : order)
        kept.push_back(std::move(items[i]));
    items = std::move(kept);
}

/// Returns a time for messages: the shortest text that reads back as it.
std::string time_text(double time);

} // namespace wakesurf::importer
