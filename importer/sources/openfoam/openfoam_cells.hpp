// Does a mesh fit into memory, by the lengths of its lists, and do the files that say which cells a face lies between name cells that can be
// there? One number too large has VTK's reader make, or search, as many cells as that.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::importer {

/// Reads owner and neighbour of a polyMesh folder, plain or compressed, text or binary, piece by piece. What has another form is left to VTK.
/// Error: Corrupt, OverLimit. @param name  of the folder in messages
core::Result<void> check_foam_cells(const std::filesystem::path& mesh, const std::string& name);

} // namespace wakesurf::importer
