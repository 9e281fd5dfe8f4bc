// The state's file for programs other than the server: checked, copied while the server runs, restored.
#pragma once

#include "server/sessions/journal/state_content.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace wakesurf::server {

struct StateVerdict {
    StateContent content; ///< the readable part
    /// The reason why a server would not start with it.
    std::optional<core::Error> fault;
};

/// Reads the sessions of a state folder, whether a server runs there or not; changes nothing there. Makes a
/// temporary copy. Error: NotFound, Io, Unsupported.
core::Result<StateVerdict> check_state(const std::filesystem::path& folder);

/// Copies a state folder's sessions into one new file (0600), and checks the copy. Edits continue meanwhile.
/// Returns its content. Error: NotFound, Io; Corrupt if it is not sound; the file is not made then.
core::Result<StateContent> back_up_state(const std::filesystem::path& folder,
                                         const std::filesystem::path& file);

struct RestoredState {
    StateContent content; ///< of the new file
    /// The name of the file, in the folder, that has the earlier content; empty without one.
    std::string replaced;
    bool made_folder = false; ///< the folder was missing
};

/// Restores the sessions of a file, a backup or any state's file, into a folder that no server uses. The
/// earlier content stays beside it under another name. `damaged`: restores the readable part of a damaged
/// file. Error: NotFound, Io, OverLimit (a server runs); Corrupt.
core::Result<RestoredState>
restore_state(const std::filesystem::path& folder, const std::filesystem::path& file, bool damaged);

} // namespace wakesurf::server
