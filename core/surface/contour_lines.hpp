// Lines on a finished surface where one of its parameters is constant: timelines (t), streamlines, pathlines
// or streaklines (s). By-products of the mesh, as in McLoughlin, Laramee, Zhang, Easy Integral Surfaces, CGI
// 2009.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <array>
#include <span>
#include <vector>

namespace wakesurf::core {

/// A line in a surface along which a parameter has one value.
struct ContourLine {
    double value = 0.0;  ///< of the parameter
    bool closed = false; ///< it ends where it begins
    /// The line: at least two points, no two neighbours the same; a closed one does not repeat its first.
    std::vector<Vec3> points;
    std::vector<double> carried{}; ///< ContourOptions::carried at each of them
};

/// The meaning of a parameter, and the values that lines carry.
struct ContourOptions {
    /// The parameter is that of a closed rake, 0 to below 1: beside its last column lies its first.
    bool wraps = false;
    /// One entry a vertex, interpolated to the points of lines; may be empty.
    std::span<const double> carried{};
};

/// Lines along which `parameter` (mesh.s or mesh.t) takes each of `values`; they run from cell side to cell
/// side, linear in between, so they lie in the mesh that is drawn. Cost: O(values times cells). REQUIRES:
/// parameter has one entry a vertex.
std::vector<ContourLine> contour_lines(const QuadComplex& mesh,
                                       std::span<const double> parameter,
                                       std::span<const double> values,
                                       const ContourOptions& options = {});

/// Returns `count` values evenly spaced between the smallest and the largest of a parameter, both left out;
/// of one that wraps, round.
std::vector<double>
evenly_spaced(std::span<const double> parameter, std::size_t count, bool wraps = false);

/// Returns a parameter at the vertices of one cell's outline, without a jump where it wraps.
std::array<double, 8>
outline_values(const CellPolygon& outline, std::span<const double> parameter, bool wraps);

/// Returns the length from the first point to the last one, without the side that closes a closed line.
double length_of(const ContourLine& line);

} // namespace wakesurf::core
