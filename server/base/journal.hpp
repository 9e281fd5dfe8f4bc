// The interface of the journal to sessions, whose records it keeps beyond the server's life: changes go in on
// the loop's thread and are acknowledged once they are on the disk.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Holds a record as it is now, or its deletion.
struct JournalEntry {
    std::string
        type; ///< `session`, `rake`, `surface`, `slice`, `lines`, `bookmark`, `annotation`, `grant`, ...
    std::string id;
    /// JSON text; empty: deleted.
    std::optional<std::string> record;
};

/// Holds a record that a start could not use. It is stored out of reach of edits.
struct KeptAside {
    std::string type;
    std::string id;
    std::string why;        ///< for people
    std::int64_t since = 0; ///< seconds since 1970

    bool operator==(const KeptAside&) const = default;
};

/// Stores changes. Loop thread only; no call blocks.
class Journal {
  public:
    virtual ~Journal() = default;

    /// Queues the changes of one edit; they are stored as a whole or not at all.
    virtual void write(const std::string& session, std::vector<JournalEntry> entries) = 0;

    /// Moves stored records out of use, to where nothing overwrites them.
    virtual void set_aside(const std::string& session, std::vector<KeptAside> records) {
        static_cast<void>(session), static_cast<void>(records);
    }

    /// Deletes a session and all its records, those set aside as well.
    virtual void remove(const std::string& session) = 0;

    /// Calls back on the loop once everything written so far is on the disk. Error: Io while that is
    /// impossible.
    virtual void settled(std::function<void(core::Result<void>)> done) = 0;

    /// Returns why the disk does not take changes at present; empty while it does.
    virtual std::optional<core::Error> refusal() const { return std::nullopt; }
};

} // namespace wakesurf::server
