// Obstacle geometry for display: triangles, of built-in bodies counter-clockwise as seen from the fluid, of
// stored walls turned as their source has them; and the patches that the source divides its boundary into.
#pragma once

#include "core/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace wakesurf::core {

/// A part of the boundary by the name that the source gives it.
struct BoundaryPatch {
    enum class Kind {
        Wall, ///< a part of the body
        Side, ///< a wall in a side of the box round the domain, which would hide what is in it
        Other ///< no wall: an inlet, an outlet, a plane of symmetry
    };
    std::string name;
    Kind kind = Kind::Wall;
    std::uint64_t triangles = 0;

    bool operator==(const BoundaryPatch&) const = default;
};

/// A body as triangles.
struct WallGeometry {
    std::vector<Vec3f> points;                           ///< corners of the triangles
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< numbers of three points each
    /// Have the triangles one after the other, the walls first, and share no points with patches of another
    /// kind. Empty: all triangles are the body's.
    std::vector<BoundaryPatch> patches{};
};

/// Returns how many of the triangles are the body's, which come first.
std::size_t body_triangles(const std::vector<BoundaryPatch>& patches, std::size_t all);

/// Returns the patches of the kind Wall alone, with their points: the first ones.
WallGeometry body_of(WallGeometry walls);

} // namespace wakesurf::core
