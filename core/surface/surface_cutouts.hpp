// Pieces cut out of a surface: ribbons along lines of one of its parameters, and arrows along the flow. Their
// polygons are parts of the mesh's own cells, so they lie in it. By-products as in McLoughlin, Laramee,
// Zhang, Easy Integral Surfaces, CGI 2009.
#pragma once

#include "core/surface/even_lines.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

struct Cutouts {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> connectivity; ///< of one polygon after the other
    std::vector<std::uint32_t> ends;         ///< of each in `connectivity`
    std::vector<double> value;               ///< of the line each belongs to

    struct Size {
        std::size_t points, polygons;
    };
};

/// Limits the polygons of ribbons, each a part of one cell, and arrows: more are an error, OverLimit, before
/// there is no memory for them.
inline constexpr std::size_t most_cutouts = 2'000'000;
inline constexpr std::size_t most_arrows = 100'000;

/// The parts of the surface within half of `width` of the lines of `levels`, measured on the surface, where
/// those are.
/// @param unit  lengths_per_unit of the parameter. Cost: O(levels times cells).
Result<Cutouts> ribbons(const QuadComplex& mesh,
                        std::span<const double> parameter,
                        std::span<const double> unit,
                        std::span<const EvenLevel> levels,
                        double width,
                        bool wraps);

struct ArrowOptions {
    /// The lines are the flow's, as those of mesh.s on stream and path surfaces: arrows bend with them. Else
    /// each points the way of the velocity in the surface, its middle on the line.
    bool along_lines = true;
    bool wraps = false;
};

/// Cuts out arrows, `spacing` from one to the next along a line and between lines; a head is as long and as
/// wide as `width`, behind it is a shaft of a third of that and twice as long.
/// @param lines  of mesh.s, as even_lines returns them
Result<Cutouts> arrows(const QuadComplex& mesh,
                       std::span<const ContourLine> lines,
                       double spacing,
                       double width,
                       const ArrowOptions& options);

} // namespace wakesurf::core
