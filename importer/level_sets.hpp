// Extracts level sets for a server, in a process that sees only a grid and the values of one field, in memory
// shared with the server: VTK's flying edges on structured grids, its contour filter for linear cells on
// meshes.
#pragma once

#include "core/base/result.hpp"

namespace wakesurf::importer {

/// Answers requests until the sender closes the socket: messages and memory as in importer/level_message.hpp.
/// Reads no file. Error: Corrupt, Io.
/// @param talk    a socket, for both directions
/// @param memory  the descriptor of the memory shared by the sender
core::Result<void> answer_level_requests(int talk, int memory);

} // namespace wakesurf::importer
