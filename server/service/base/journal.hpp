// Where the records of sessions are kept beyond the server's life, as sessions see it: changes go in on the
// loop's thread and are told of once they are on the disk.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Holds one record as it is now, or gone.
struct JournalEntry {
    std::string type; ///< `session`, `rake`, `surface`, `bookmark`, `annotation`, `grant`, ...
    std::string id;
    std::optional<std::string> record; ///< JSON text; nothing: deleted
};

/// A record that a start could not use. It is kept, where no edit reaches it.
struct KeptAside {
    std::string type;
    std::string id;
    std::string why;        ///< for people
    std::int64_t since = 0; ///< seconds since 1970

    bool operator==(const KeptAside&) const = default;
};

/// Loop thread only; nothing here waits.
class Journal {
  public:
    virtual ~Journal() = default;

    /// Takes what one edit changed; it is kept as a whole or not at all.
    virtual void write(const std::string& session, std::vector<JournalEntry> entries) = 0;

    /// Takes records, as they are kept, out of those in use to a place of their own, where nothing
    /// overwrites them.
    virtual void set_aside(const std::string& session, std::vector<KeptAside> records) {
        static_cast<void>(session), static_cast<void>(records);
    }

    /// Forgets a session and all its records, those kept aside as well.
    virtual void remove(const std::string& session) = 0;

    /// Calls back on the loop once everything written so far is on the disk. Error: Io while that cannot be.
    virtual void settled(std::function<void(core::Result<void>)> done) = 0;

    /// Why the disk does not take changes just now; nothing while it does.
    virtual std::optional<core::Error> refusal() const { return std::nullopt; }
};

} // namespace wakesurf::server
