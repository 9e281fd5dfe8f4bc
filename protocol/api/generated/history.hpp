// Made by protocol/api/generate from history.schema.json: do not edit.
// Undo: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of history.undo: Takes back the caller's newest edit, or a whole gesture (or drag) at
/// once. It never undoes the work of others: an edit is skipped if someone else has changed its
/// records since.
struct HistoryUndo {
    static constexpr std::string_view method = "history.undo";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const HistoryUndo&) const = default;
};

void read(CheckedJson& in, HistoryUndo& out);

/// Parameters of history.redo: Repeats the caller's newest edit that was taken back.
struct HistoryRedo {
    static constexpr std::string_view method = "history.redo";

    /// an id from session.list; it may be left out on a WebSocket that has joined a session, and
    /// with a share link
    std::optional<std::string> session;

    bool operator==(const HistoryRedo&) const = default;
};

void read(CheckedJson& in, HistoryRedo& out);

} // namespace wakesurf::protocol
