// Keeps up to date what a list tells of a session besides its records: its participants, when it was last
// used, whether it was ever edited.
#pragma once

#include "protocol/api/record_text.hpp"
#include "server/base/journal.hpp"
#include "server/base/unix_time.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Loop thread only. Changes reach the journal with what caused them, the time of an edit once a minute.
class ProfileKeeper {
  public:
    /// Describes a session made now.
    explicit ProfileKeeper(UnixTime unix_time);

    const protocol::SessionProfile& value() const { return value_; }

    /// Takes it from the journal, for a session made before now.
    void restore(protocol::SessionProfile kept);

    void arrived(protocol::SessionPerson person);
    void used();
    void edited();
    void made_on_purpose();
    void copied(const std::string& session, const std::string& name);
    void deleted(std::optional<std::int64_t> when);

    /// Says which values a dataset had (store::ValueMarks::text); empty: no surface has used it.
    std::string data(const std::string& dataset) const;
    void set_data(const std::string& dataset, std::string values);

    /// Returns what is to be written, if anything has changed that should be; it counts as written then.
    std::optional<JournalEntry> due();

    /// Returns the entry as it is now.
    JournalEntry entry() const;

  private:
    UnixTime unix_time_;
    protocol::SessionProfile value_;
    bool changed_ = false;
    std::int64_t kept_at_ = 0;
};

} // namespace wakesurf::server
