// When a moving surface's cells are cut, joined, reconnected or torn.
#pragma once

#include "core/surface/moving/insertion.hpp"

#include <cstdint>

namespace wakesurf::core {

struct RefinementRules {
    double separation = 1.0; ///< longest sub-edge allowed
    double merge = 0.35; ///< of the separation, at most 0.5: cells with both sides shorter are joined; 0: never
    double joined =
        0.7; ///< of the separation: longest side of what they become; less than 1, so that nothing is cut again
    double cosine = -1.0;  ///< of the largest angle between neighbouring normals; -1: any
    double finest = 0.125; ///< of the separation: cells are not cut below this for curvature
    double tear_size =
        0.25; ///< of the separation: cells at a tear are cut down to this before they are deleted
    double least_s = 1e-6; ///< parameter distances below which the surface is discontinuous
    double least_t = 1e-6; ///< in the unit of t
    double least_s_at_wall =
        0.0; ///< the same beside an obstacle, where a surface that still diverges is taken to split
    double least_t_at_wall = 0.0;
    InsertionPolicy policy = InsertionPolicy::Hermite;
    double trusted_sagitta =
        0.05; ///< Hermite: bulge of an edge, over its length, beyond which its middle is traced again
    bool retrace =
        true; ///< tracing again is possible; else such edges are not made by reconnecting
    bool tangents = true;  ///< transported tangents are there to look at
    bool obstacle = false; ///< edges may cross solid parts
    bool reconnect = true; ///< glide; false only to measure what it gains
    std::uint64_t max_quads = 1'000'000;
};

} // namespace wakesurf::core
