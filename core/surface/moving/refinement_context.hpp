// The rules for cutting, joining and tearing a moving surface's edges, and the data that the phases of its
// refinement work on.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/moving/moving_mesh.hpp"

#include <cstdint>
#include <stop_token>

namespace wakesurf::core {

/// The placement of new vertices. Hermite: they are interpolated, and traced again if that may be too far
/// off. Exact: all are traced again.
enum class InsertionPolicy { Hermite, Exact };

/// Sizes are parts of the separation.
struct RefinementRules {
    double separation = 1.0; ///< longest edge allowed
    double cosine = -1.0;    ///< of the largest angle between neighbouring normals; -1: any
    double finest = 0.125;   ///< edges are not cut below this for their bulge
    double tear_size = 0.25; ///< seeds are that close where a rake enters an obstacle
    /// Triangles lower than this that would have to be cut are deleted. Beside a jump of the velocity (folded
    /// cells of a mesh, particles that gather on a face) they have no end: 113,684 quads where 1,190 are
    /// left.
    double crumb = 1e-3;
    double merge = 0.55; ///< edges shorter than this are joined; 0: none

    /// The surface is taken to be discontinuous below this distance in the parameter.
    double least_s = 1e-6;
    double least_t = 1e-6; ///< in the unit of t
    /// The least distances beside an obstacle, at which a surface that still diverges is taken to split.
    double least_s_at_wall = 0.0;
    double least_t_at_wall = 0.0;

    InsertionPolicy policy = InsertionPolicy::Hermite;
    /// Limits, with Hermite, how far off a vertex may be before it is traced again. Where interpolated
    /// vertices stood beside traced ones with larger errors, the differences were folds that were cut, and so
    /// on: README.md here, New vertices and accuracy.
    double trusted_error = 0.02;
    bool retrace = true;   ///< tracing again is possible
    bool obstacle = false; ///< edges may cross solid parts
    std::uint64_t max_quads = 1'000'000;
    bool coarsens = true;    ///< the separation may rise to keep the quad budget
    double coarsest = 1e300; ///< no further than this
};

/// Exact rules are asked in parallel for shares of so many triangles.
inline constexpr std::size_t few_triangles = 64;

struct RefinementContext {
    MovingMesh& mesh;
    const Flow& flow;
    const RefinementRules& rules; ///< as now in force
    /// Ends every phase where it is when it is requested: the mesh is of no use then.
    const std::stop_token stop{};

    /// Returns the squared length of a part of the separation.
    double squared_separation(double part = 1.0) const {
        return part * part * rules.separation * rules.separation;
    }

    /// Longest edge allowed, squared, with what rounding may add: what is made just as long is not cut again.
    double longest_allowed() const { return squared_separation() * (1.0 + 2e-9); }
};

} // namespace wakesurf::core
