// Names of fields where a file format takes one word only.
#pragma once

#include "protocol/files/mesh_metadata.hpp"

#include <set>
#include <string>
#include <vector>

namespace wakesurf::protocol {

/// A word for each scalar, in order: what is not an ASCII letter, a digit or `_` becomes `_`, and what is taken, or was
/// given before, gets a number behind it.
std::vector<std::string> words_of(const MeshScalars& scalars, std::set<std::string> taken);

/// The same in capitals behind a `_`, as glTF has the attributes of applications.
std::vector<std::string> gltf_names(const MeshScalars& scalars, std::set<std::string> taken);

} // namespace wakesurf::protocol
