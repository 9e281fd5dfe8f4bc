// The state's file at a start: is it sound, is it of this version? Nothing of it is changed before that is
// known.
#pragma once

#include "server/service/base/unix_time.hpp"
#include "server/service/journal/commit_mark.hpp"
#include "server/service/journal/database.hpp"
#include "server/service/journal/state_content.hpp"

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
    StateContent content; ///< without faults; what is damaged is among what is kept aside
};

/// Makes the file where there is none. One of another version is copied, beside it, before anything of it is
/// changed. Error: Io; Corrupt, where records are gone or cannot be read, and Unsupported, for a file of a
/// newer program or of another one: the file and its log are then left as they are.
core::Result<OpenedState> open_state(const StateOptions& options, const CommitMark& mark);

/// What the log held is in the content, unless the log was damaged or taken away. Error: Corrupt.
/// `marked`: as it was before the content was read.
core::Result<void> check_mark(const StateContent& content,
                              const std::optional<CommitMark::Value>& marked);

/// 20261122T105500Z
std::string time_in_name(std::int64_t unix_time);

/// Returns 63 bits at random, never 0.
std::int64_t fresh_state_id();

} // namespace wakesurf::server
