// The content of the state's file, read and checked: against the checksum of each row, the sums of each
// session's rows and of all of them, and SQLite's own check of its structure.
#pragma once

#include "server/sessions/journal/state_layout.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::server {

struct StateContent {
    int layout = 0;
    StateHead head;
    std::map<std::string, std::vector<JournalEntry>> sessions; ///< sound records
    std::map<StoredKey, std::uint64_t> digests;                ///< of them
    std::vector<AsideRow> damaged;                             ///< rows with wrong checksums
    std::vector<AsideRow> aside;                               ///< set aside by earlier starts
    std::vector<std::string> faults; ///< sentences about missing and unreadable parts

    std::size_t records() const { return digests.size(); }

    /// Returns the sums of the sound records.
    std::map<std::string, RowSum> sums() const;
};

/// Reads everything, and reports faults. `now`: the time for rows set aside. Error: as Database::run, if it
/// cannot be read to the end; as layout_of.
core::Result<StateContent> read_content(Database& database, std::int64_t now);

/// Reads what is readable of a damaged file, row by row. Error: as layout_of.
core::Result<StateContent> salvage_content(Database& database, std::int64_t now);

/// Returns the error of a start with a faulty file.
core::Error damage_error(const StateContent& content);

} // namespace wakesurf::server
