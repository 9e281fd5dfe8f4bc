// The times of a series' time-steps, once all that is known of them is together.
#pragma once

#include "core/base/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct TimedEntry {
    std::string name; ///< as messages say it
    std::optional<double> time;
    bool unreadable =
        false; ///< whatever time it has is not known: one is made up between its neighbours'
    std::optional<double> number{}; ///< in the name of its file
};

struct SeriesTimes {
    std::vector<double> times; ///< strictly increasing
    std::string note;
    std::vector<double> places; ///< as SourceDescription
};

/// Where each of entries without times stands: 0, 1, 2, but further apart where numbers between theirs are missing: the
/// smallest difference counts as one.
std::vector<double> places_of(const std::vector<TimedEntry>& entries);

/// The entries' own times; 0, 1, 2, ... with a note where no entry of several has one. Error: Corrupt, naming two
/// entries, where only some have a time, two have the same, or a later entry has an earlier time.
core::Result<SeriesTimes> settle_times(std::vector<TimedEntry> entries);

/// As messages show a time: as short as tells it from others.
std::string time_text(double time);

} // namespace wakesurf::server
