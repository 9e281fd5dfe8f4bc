// Lines on a finished surface where one of its parameters is constant: timelines (t), streamlines, pathlines or streaklines
// (s). By-products of the mesh, as in McLoughlin, Laramee, Zhang, Easy Integral Surfaces, CGI 2009.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <span>
#include <vector>

namespace wakesurf::core {

struct ContourLine {
    double value = 0.0;
    bool closed = false;
    std::vector<Vec3>
        points; ///< at least two, no two neighbours the same; a closed line does not repeat its first
};

/// Lines along which `parameter` (mesh.s or mesh.t) takes each of `values`; they run from cell side to cell side, linear in
/// between, so they lie in the mesh that is drawn. Cost: O(values times cells).
/// REQUIRES: parameter has one entry a vertex.
std::vector<ContourLine> contour_lines(const QuadComplex& mesh,
                                       std::span<const double> parameter,
                                       std::span<const double> values);

/// `count` values evenly spaced between the smallest and the largest of a parameter, both left out.
std::vector<double> evenly_spaced(std::span<const double> parameter, std::size_t count);

} // namespace wakesurf::core
