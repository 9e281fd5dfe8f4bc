// How long the particles of a stream or path surface stay in a box, or in the data: each line of the surface, from its
// rake on, is cut with the box.
#pragma once

#include "core/base/box.hpp"
#include "core/surface/measures/surface_parts.hpp"

#include <optional>
#include <span>

namespace wakesurf::core {

/// Times of the particles that come into the box, by the share of the rake that released them; not_known where none
/// does.
struct Residence {
    double median, p90, mean; ///< times; a particle that is still inside has the time until then
    double entered = 0.0;     ///< the share of the rake whose particles come in
    double inside = 0.0;      ///< the share of these that are still inside when the surface ends
};

/// @param bounds  what limits the surface before the box does
/// @param ages    one a vertex
/// @param end     the age up to which particles are followed
/// @param box     nothing: all of the surface
/// @param closed  s goes round
/// Cost: O(cells), and where cells are wider than a 2048th of the rake also their share of it.
Residence residence(const QuadComplex& mesh,
                    std::span<const VertexFunction> bounds,
                    std::span<const double> ages,
                    double end,
                    const std::optional<Box>& box,
                    bool closed);

} // namespace wakesurf::core
