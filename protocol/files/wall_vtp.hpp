// A body, or patches of a boundary, as a .vtp file (VTK XML PolyData) with values at its points and the patch of each face.
#pragma once

#include "core/dataset/wall_geometry.hpp"
#include "core/surface/quad_complex.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::protocol {

struct WallValues {
    std::string name;
    int components = 1;
    std::vector<float> values; ///< as many as that a vertex; NaN where there is none
};

/// Returns the file. Same input, same bytes. With patches each face has the number of its patch as `Patch`, -1 beyond them, and the field
/// data their names as `PatchNames`. @param time  at which the values hold; empty: the shape alone
std::string wall_vtp(const core::QuadComplex& mesh,
                     const std::vector<core::BoundaryPatch>& patches,
                     const std::vector<WallValues>& values,
                     std::optional<double> time);

} // namespace wakesurf::protocol
