// Lines at even distances on a surface: as many of one parameter's as fit, ending where the surface narrows
// and beginning where it widens. By-products of the mesh, as in McLoughlin, Laramee, Zhang, Easy Integral
// Surfaces, CGI 2009.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/contour_lines.hpp"

#include <limits>
#include <span>
#include <vector>

namespace wakesurf::core {

/// Returns for every vertex the distance on the surface from one value of a parameter to the next whole one:
/// the inverse of its gradient along the surface. Infinite where it does not change. Cost: O(cells).
std::vector<double>
lengths_per_unit(const QuadComplex& mesh, std::span<const double> parameter, bool wraps);

/// A value of the parameter, and where on the surface its line is: where a unit is at least so long.
struct EvenLevel {
    double value;
    double least_length; ///< a unit
};

/// Values whose lines are about `spacing` apart: two neighbours between 0.7 and 1.4 of it, and one line at
/// least. They are multiples of powers of two, so that lines stay where they are as a surface grows.
/// @param unit  lengths_per_unit. Error: OverLimit where there are more than `most` values. Cost: O(cells)
///              for each halving of the distance.
Result<std::vector<EvenLevel>> even_levels(const QuadComplex& mesh,
                                           std::span<const double> parameter,
                                           std::span<const double> unit,
                                           double spacing,
                                           bool wraps,
                                           std::size_t most);

/// The lines of those values where they are: open pieces of at least `spacing`, and closed lines that are
/// there all the way.
std::vector<ContourLine> even_lines(const QuadComplex& mesh,
                                    std::span<const double> parameter,
                                    std::span<const double> unit,
                                    std::span<const EvenLevel> levels,
                                    double spacing,
                                    bool wraps);

} // namespace wakesurf::core
