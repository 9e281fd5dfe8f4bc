// Made by protocol/api/generate from history.schema.json: do not edit.
// Undo: what methods take. Readers leave what is wrong in `in`.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/generated/shared.hpp"

#include <string_view>

namespace wakesurf::protocol {

/// Holds the parameters of history.undo.
struct HistoryUndo : InSession {
    static constexpr std::string_view method = "history.undo";
};

/// Holds the parameters of history.redo.
struct HistoryRedo : InSession {
    static constexpr std::string_view method = "history.redo";
};

} // namespace wakesurf::protocol
