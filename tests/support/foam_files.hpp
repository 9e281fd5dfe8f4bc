// Writes OpenFOAM's files: a mesh, and fields on it, as text or binary.
#pragma once

#include "tests/support/foam_mesh.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wakesurf::tests {

struct FoamField {
    std::string name = "U";
    std::string dimensions = "[0 1 -1 0 0 0 0]";
    std::vector<std::vector<double>> values; ///< a cell each; one or three numbers
    /// The text between a patch's braces; zeroGradient if missing.
    std::map<std::string, std::string> patches;
};

/// Writes the files of a mesh below `folder`/polyMesh.
void write_foam_mesh(const std::filesystem::path& folder,
                     const FoamMesh& mesh,
                     bool binary = false);

/// Writes `folder`/name.
void write_foam_field(const std::filesystem::path& folder,
                      const FoamMesh& mesh,
                      const FoamField& field,
                      bool binary = false);

/// Returns the rows of `field` for the cells of a part.
FoamField part_of(const FoamField& field, const FoamMesh& part);

} // namespace wakesurf::tests
