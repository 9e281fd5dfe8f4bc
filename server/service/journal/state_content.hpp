// Everything in the state's file, read and checked: against the checksum of each row, the sums of each
// session's rows and of all of them, and SQLite's own check of its structure.
#pragma once

#include "server/service/journal/state_layout.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

struct StateContent {
    int layout = 0;
    StateHead head;                                            ///< of layout 1 nothing is known
    std::map<std::string, std::vector<JournalEntry>> sessions; ///< sound records
    std::map<StoredKey, std::uint64_t> digests;                ///< of them
    std::vector<AsideRow> damaged;   ///< rows with another checksum than theirs
    std::vector<AsideRow> aside;     ///< kept aside by earlier starts
    std::vector<std::string> faults; ///< sentences: something is gone, or cannot be read

    std::size_t records() const { return digests.size(); }

    /// Covers the sound records.
    std::map<std::string, RowSum> sums() const;
};

/// Reads all there is, and says what is not as it was written. `now`: since when what is damaged is kept
/// aside. Error: as Database::run, where it cannot be read to the end; as layout_of.
core::Result<StateContent> read_content(Database& database, std::int64_t now);

/// Reads what can be read of a damaged file, row by row. Error: as layout_of.
core::Result<StateContent> salvage_content(Database& database, std::int64_t now);

/// Says what a start tells of a file with faults.
core::Error damage_error(const StateContent& content);

} // namespace wakesurf::server
