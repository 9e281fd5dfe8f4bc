// The state's file as others than the server need it: checked, copied while the server runs, put back.
#pragma once

#include "server/service/journal/state_content.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace wakesurf::server {

struct StateVerdict {
    StateContent content;             ///< what can be read
    std::optional<core::Error> fault; ///< why a server would not start with it
};

/// Reads what is kept in a state folder, whether a server runs there or not; changes nothing there. Takes
/// room for a copy among the temporary files. Error: NotFound, Io, Unsupported.
core::Result<StateVerdict> check_state(const std::filesystem::path& folder);

/// Copies a state folder's sessions into one file that is not there yet (0600), and checks the copy. Edits
/// go on meanwhile. Returns what is in it. Error: NotFound, Io; Corrupt where it is not sound; the file is
/// not made then.
core::Result<StateContent> back_up_state(const std::filesystem::path& folder,
                                         const std::filesystem::path& file);

struct RestoredState {
    StateContent content; ///< of the new file
    std::string
        replaced; ///< name of the file, in the folder, that has what was there before; empty: nothing was
    bool made_folder = false; ///< the folder was not there
};

/// Puts the sessions of a file, a backup or any state's file, into a folder no server runs in. What was
/// there stays beside it under another name. `damaged`: of a damaged file what can be read. Error: NotFound,
/// Io, OverLimit (a server runs); Corrupt.
core::Result<RestoredState>
restore_state(const std::filesystem::path& folder, const std::filesystem::path& file, bool damaged);

} // namespace wakesurf::server
