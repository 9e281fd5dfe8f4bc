// Made by protocol/api/generate from history.schema.json: do not edit.
// Undo: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/checked_json.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Parameters of history.undo: Takes back the caller's newest edit, a whole gesture (or drag) at
/// once. Never undoes others' work: an edit whose records someone else has changed since is
/// skipped.
struct HistoryUndo {
    static constexpr std::string_view method = "history.undo";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const HistoryUndo&) const = default;
};

void read(CheckedJson& in, HistoryUndo& out);

/// Parameters of history.redo: Makes the caller's newest undone edit again.
struct HistoryRedo {
    static constexpr std::string_view method = "history.redo";

    /// an id from session.list; may be left out on a WebSocket that has joined one, and with a
    /// share link
    std::optional<std::string> session;

    bool operator==(const HistoryRedo&) const = default;
};

void read(CheckedJson& in, HistoryRedo& out);

} // namespace wakesurf::protocol
