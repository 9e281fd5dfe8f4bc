// The closed curve that a tube has in common with a plane, or that its particles of one age form.
#pragma once

#include "core/surface/measures/surface_parts.hpp"

#include <tl/expected.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::core {

struct ClosedCurve {
    std::vector<Vec3> points;                ///< the first is not repeated
    std::vector<std::vector<double>> errors; ///< at them
    int sense = 1;                           ///< 1 where s grows along it, else -1
};

/// Why there is no such curve, or no flux through it.
struct NoCurve {
    enum class Why { NotMet, Several, Open, Younger, LeavesData };
    Why why;
    std::size_t curves = 0; ///< Several: how many there are

    /// Returns it in words for people, of a plane.
    std::string of_plane() const;

    /// Returns it in words for people, of the particles of one age.
    std::string of_ring() const;
};

/// Returns the curve along which a function is 0, if it is one and closed.
/// @param ages    one a vertex, and the most that there may be on the curve
/// @param errors  lists of one length a vertex
tl::expected<ClosedCurve, NoCurve> closed_curve(const QuadComplex& mesh,
                                                const VertexFunction& function,
                                                std::span<const double> ages,
                                                double most_age,
                                                std::span<const std::span<const double>> errors);

} // namespace wakesurf::core
