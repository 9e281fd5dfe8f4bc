// The state's file at a start: its soundness and version are checked before anything of it is changed.
#pragma once

#include "server/base/unix_time.hpp"
#include "server/sessions/journal/commit_mark.hpp"
#include "server/sessions/journal/database.hpp"
#include "server/sessions/journal/state_content.hpp"

#include <string>

namespace wakesurf::server {

struct StateOptions {
    std::string file;
    const char* vfs = nullptr; ///< SQLite's name of the file system; null: the machine's
    std::string writer{};      ///< version of the program; empty: this one's
    UnixTime now = unix_seconds;
};

struct OpenedState {
    Database database;
    StateContent content; ///< without faults; damaged rows have been set aside
};

/// Opens the file, and makes it if it is missing. One of another version is copied, beside it, before it is
/// changed. Error: Io; Corrupt, if records are missing or unreadable, and Unsupported, for a file of a newer
/// program or of another one: the file and its log are then left unchanged.
core::Result<OpenedState> open_state(const StateOptions& options, const CommitMark& mark);

/// Checks that the content includes the log, unless that was damaged or removed. Error: Corrupt. `marked`:
/// the mark before the content was read.
core::Result<void> check_mark(const StateContent& content,
                              const std::optional<CommitMark::Value>& marked);

/// Returns a time as 20261122T105500Z.
std::string time_in_name(std::int64_t unix_time);

/// Returns 63 random bits, never 0.
std::int64_t fresh_state_id();

} // namespace wakesurf::server
