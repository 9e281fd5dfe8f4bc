// Small OpenFOAM meshes: a block of graded boxes, on request with one half refined 2:1, so that boxes at the
// interface become polyhedra with hanging nodes; whole, or one part of a decomposition.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace wakesurf::tests {

struct FoamMesh {
    struct Face {
        std::vector<int> nodes; ///< seen from outside the owner counter-clockwise
        int owner = 0;
        int neighbour = -1;
    };

    struct Patch {
        std::string name;
        std::string type;
        int start = 0;
        int size = 0;
        int other_part = -1;       ///< of processor patches
        std::string other_patch{}; ///< of cyclic ones
    };

    std::vector<std::array<double, 3>> points;
    std::vector<Face> faces; ///< inner ones first, then patch by patch
    std::vector<Patch> patches;
    std::vector<std::array<double, 3>> centres; ///< of the cells
    std::vector<int> cells;                     ///< their numbers in the whole mesh
    int part = -1;
};

struct FoamBlock {
    std::array<int, 3> boxes{4, 3, 2};
    bool refined = false; ///< the boxes with x above the middle are eight each
};

/// Makes a block with the patches inlet (x low), outlet, floor (y low, a wall), lid (a wall), sides (z).
FoamMesh foam_block_mesh(const FoamBlock& block);

/// Returns the two parts left and right of a cut across x, `fraction` of the cells on the left.
std::array<FoamMesh, 2> decompose(const FoamMesh& whole, double fraction = 0.5);

} // namespace wakesurf::tests
