// Records to what the journal keeps, and back from a journal that may be damaged: what cannot be a record is
// left out and said, the rest is there.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/record_text.hpp"
#include "server/base/journal.hpp"
#include "server/sessions/records/session_records.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Returns the rake that a surface is kept with: none for a level surface, which begins at none.
std::optional<std::string> rake_kept(const core::SurfaceParameters& parameters,
                                     const std::optional<std::string>& rake);

JournalEntry entry_of(const Record& record);
JournalEntry entry_of(const protocol::ClockRecord& clock);
JournalEntry entry_of(const protocol::SessionHead& head);
JournalEntry entry_of_thumbnail(const std::string& base64);
/// Checks what a record has to be, on whichever way it comes: from a journal, from a file, and
/// (check_record) from an edit. Pure. Error: Corrupt, OverLimit; InvalidArgument for what its kind of
/// surface does not have, or lacks.
core::Result<Record> read_record(const RecordKey& key, const std::string& text);

/// Checks whether a record would be read back as it is, so that what is accepted is what the next start
/// accepts. Its rakes are for the caller to look for. Cost: its text is written and read. Error:
/// InvalidArgument.
core::Result<void> check_record(const Record& record);

/// Checks like check_record.
core::Result<void> check_clock(const protocol::ClockRecord& clock);

/// Holds an entry that was left out.
struct RefusedEntry {
    std::string type;
    std::string id;
    core::Error error; ///< its message names the entry
};

/// Returns it with the error's message naming the entry.
RefusedEntry refused_entry(const JournalEntry& entry, core::Error error);

struct RestoreReport {
    std::size_t restored = 0; ///< records
    std::vector<RefusedEntry> refused;
};

struct StoredRecords {
    std::string name; ///< of the session; empty where it was not kept
    std::uint64_t seq = 0;
    protocol::SessionUnits units{};
    SessionRecords records;
    std::optional<protocol::ClockRecord> clock; ///< as it was when it was kept
    std::optional<protocol::SessionProfile> profile;
    std::string thumbnail; ///< base64
    RestoreReport report;
};

/// Reads entries in any order, one per record. Entries of other types belong to other readers and are left
/// alone.
StoredRecords read_entries(std::span<const JournalEntry> entries);

} // namespace wakesurf::server
