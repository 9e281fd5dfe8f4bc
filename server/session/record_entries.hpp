// Records to what the journal keeps, and back from a journal that may be damaged: what cannot be a record is left out
// and said, the rest is there.
#pragma once

#include "core/base/result.hpp"
#include "protocol/messages_session.hpp"
#include "protocol/record_text.hpp"
#include "server/session/journal.hpp"
#include "server/session/session_records.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

JournalEntry entry_of(const Record& record);
JournalEntry entry_of(const protocol::ClockRecord& clock);
JournalEntry entry_of(const protocol::SessionHead& head);
JournalEntry entry_of_thumbnail(const std::string& base64);
JournalEntry entry_without(const RecordKey& key);

struct RestoreReport {
    std::size_t restored = 0;         ///< records
    std::vector<core::Error> refused; ///< one for each that was left out, naming it
};

struct KeptRecords {
    std::string name; ///< of the session; empty where it was not kept
    std::uint64_t seq = 0;
    SessionRecords records;
    std::optional<protocol::ClockRecord> clock; ///< as it was when it was kept
    std::optional<protocol::SessionProfile> profile;
    std::string thumbnail; ///< base64
    RestoreReport report;
};

/// Entries in any order, one per record. Other types of entry are somebody else's and left alone.
KeptRecords read_entries(std::span<const JournalEntry> entries);

} // namespace wakesurf::server
