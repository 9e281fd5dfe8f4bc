// When a moving surface's cells are cut, joined, reconnected or torn.
#pragma once

#include "core/surface/moving/insertion.hpp"

#include <algorithm>
#include <cstdint>

namespace wakesurf::core {

/// Sizes are parts of the separation.
struct RefinementRules {
    double separation = 1.0; ///< longest sub-edge allowed
    double cosine = -1.0;    ///< of the largest angle between neighbouring normals; -1: any
    double finest = 0.125;   ///< cells are not cut below this for curvature
    double tear_size = 0.25; ///< cells at a tear are cut down to this before they are deleted
    /// Cells all of whose sides are below this are deleted, and so are those with one such side that would have to be cut. Beside a jump
    /// of the velocity (folded cells of a mesh, particles that gather on a face) they have no end: 113,684 where 1,190 are left.
    double crumb = 1e-3;
    /// Two cells are joined when what comes of them is shorter than twice this; 0: never, at most 0.5.
    double merge = 0.35;

    double least_s =
        1e-6; ///< parameter distances below which the surface is taken to be discontinuous
    double least_t = 1e-6; ///< in the unit of t
    /// The same beside an obstacle, where a surface that still diverges is taken to split.
    double least_s_at_wall = 0.0;
    double least_t_at_wall = 0.0;

    InsertionPolicy policy = InsertionPolicy::Hermite;
    /// Line and Hermite: a vertex that may be further off is traced again. Where interpolated vertices stood beside traced ones with larger
    /// errors, the differences were folds that were cut, and so on: core/README.md, How a streak or time surface moves.
    double trusted_error = 0.02;
    bool retrace =
        true; ///< tracing again is possible; else reconnecting makes no edges that want it
    bool tangents = true;  ///< transported tangents are there to look at
    bool obstacle = false; ///< edges may cross solid parts
    bool reconnect = true; ///< false only to measure what it gains
    std::uint64_t max_quads = 1'000'000;
    bool coarsens = true;    ///< the separation may rise to keep the quad budget
    double coarsest = 1e300; ///< no further than this

    /// Longest side of joined cells: below the separation, or they would be cut again.
    double joined() const { return std::min(2.0 * merge, 0.95) * separation; }
};

} // namespace wakesurf::core
