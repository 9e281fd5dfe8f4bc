// Names of fields where a file format takes one word only.
#pragma once

#include "protocol/files/mesh_metadata.hpp"

#include <set>
#include <string>
#include <vector>

namespace wakesurf::protocol {

/// Returns a word for each scalar, in order: any character but ASCII letters, digits and `_` becomes `_`, and
/// a word that is in `taken`, or was given before, gets a number behind it.
std::vector<std::string> words_of(const MeshScalars& scalars, std::set<std::string> taken);

/// Returns such words in capitals behind a `_`, which glTF prescribes for attributes of applications.
std::vector<std::string> gltf_names(const MeshScalars& scalars, std::set<std::string> taken);

} // namespace wakesurf::protocol
