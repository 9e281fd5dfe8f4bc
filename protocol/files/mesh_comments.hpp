// The metadata of an exported mesh as lines of text, for the comments of .ply and .obj.
#pragma once

#include "protocol/files/mesh_metadata.hpp"

#include <string>
#include <vector>

namespace wakesurf::protocol {

/// Returns `kind stream`, `rake 0,0,0 1,0,0`, ...; no line has a control character in it, for any name of the
/// dataset.
std::vector<std::string> mesh_comments(const MeshMetadata& metadata);

} // namespace wakesurf::protocol
