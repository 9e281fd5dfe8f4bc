// Extracts level sets for a server, in a process that knows nothing but a grid and the values of one field, in memory that the server
// shares with it: VTK's flying edges on structured grids, its contour filter for linear cells on meshes.
#pragma once

#include "core/base/result.hpp"

namespace wakesurf::importer {

/// Answers requests until their sender ends: messages and memory as in importer/level_message.hpp. Reads no file.
/// @param talk    a socket, for both ways
/// @param memory  what the sender shares
/// Error: Corrupt, Io.
core::Result<void> answer_level_requests(int talk, int memory);

} // namespace wakesurf::importer
