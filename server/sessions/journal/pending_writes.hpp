// The changes since the last commit: only the newest state of every record, however often it was edited.
#pragma once

#include "server/base/journal.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::server {

struct StoredKey {
    std::string session;
    std::string type;
    std::string id;

    auto operator<=>(const StoredKey&) const = default;
};

/// Holds changes. Its size is bounded by that of the records, however long writing fails.
struct PendingWrites {
    std::set<std::string> removed;        ///< sessions to forget, before all else
    std::map<StoredKey, KeptAside> aside; ///< records to move, before `records` are written
    /// JSON text; empty: deleted.
    std::map<StoredKey, std::optional<std::string>> records;

    bool empty() const { return removed.empty() && aside.empty() && records.empty(); }

    void write(const std::string& session, std::vector<JournalEntry> entries);
    void set_aside(const std::string& session, std::vector<KeptAside> records);
    void remove(const std::string& session);

    /// Adds changes that were made before these and are not on the disk yet.
    void follow(PendingWrites older);

    /// Drops the deletions of records that `stored` does not have.
    void drop_needless(const std::map<StoredKey, std::uint64_t>& stored);
};

} // namespace wakesurf::server
