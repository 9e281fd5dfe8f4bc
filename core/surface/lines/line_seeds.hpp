// Where streamlines begin: on a line, in a rectangle, on a sphere, off the walls or on them.
#pragma once

#include "core/base/box.hpp"
#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

struct LineSeeds {
    enum class Kind { Line, Plane, Sphere, Walls, Along };
    Kind kind = Kind::Line;
    /// Line: its 2 ends. Plane: a corner of a parallelogram and the 2 corners next to it. Sphere: its centre. Walls, and Along, of lines
    /// that lie on them: none.
    std::vector<Vec3> points;
    double distance = 0.0;    ///< Sphere: its radius. Walls: how far off them; other kinds: 0
    std::uint32_t seeds = 50; ///< about as many: a plane has a whole number of rows
    std::vector<std::string>
        patches{}; ///< Walls, Along: of the boundary, also such as are no walls; empty: all walls of bodies

    bool operator==(const LineSeeds&) const = default;
};

/// Says whether seeds lie off walls or on them.
inline bool of_walls(LineSeeds::Kind kind) {
    return kind == LineSeeds::Kind::Walls || kind == LineSeeds::Kind::Along;
}

/// Checks seeds that are asked for, before anything is read. Error: InvalidArgument (too few or many points, numbers that are not finite,
/// what has no length, area or radius or a far too large one), OutOfDomain where all of them lie beside the domain.
Result<void> check_line_seeds(const LineSeeds& seeds, const Box& domain);

/// Returns the seeds: on a line at even distances, its ends included; in a plane at the centres of equal parts, of about the same length
/// and width; on a sphere evenly all round. REQUIRES: checked seeds, not of walls.
std::vector<Vec3> line_seed_places(const LineSeeds& seeds);

/// A place on a wall, and its normal of length 1, whichever way the wall is turned.
struct WallPlace {
    Vec3 place{0.0};
    Vec3 normal{0.0};
    std::size_t triangle = 0; ///< which of wall_triangles
};

/// Returns the two triangles of each cell, one where it is a triangle.
std::vector<std::array<VertexId, 3>> wall_triangles(const QuadComplex& wall);

/// Returns so many places on a wall, evenly by area, and as far from each other as that goes: each is that of many more which is farthest from
/// all before it. The same for the same wall. Nothing where the wall has no area. Error: Cancelled.
Result<std::vector<WallPlace>>
even_wall_places(const QuadComplex& wall, std::size_t count, const std::stop_token& stop);

} // namespace wakesurf::core
