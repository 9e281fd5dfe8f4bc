// How much the area of a surface, and the flux through it, change to first order when every vertex moves by its
// error in the direction that counts most: across the surface area changes by twice the mean curvature and flux by the
// divergence; at the border both change with what is added or taken away there. The errors count as if all were on one
// side, so no arrangement of smooth errors of these sizes does more.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/measures/surface_parts.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <span>
#include <stop_token>
#include <unordered_set>
#include <vector>

namespace wakesurf::core {

/// Changes of area and flux, and what of the area they leave out.
struct ErrorSpread {
    double area = 0.0;     ///< the change, an area
    double flux = 0.0;     ///< the change, a volume per time
    double left_out = 0.0; ///< the area whose error is not known
};

/// Spreads errors over a mesh.
class ErrorSpreader {
  public:
    /// @param times  at which each vertex is there
    /// Error: what sampling reports. Cost: a few thousand samples, O(cells).
    static Result<ErrorSpreader> of(const SurfacePlan& plan,
                                    const QuadComplex& mesh,
                                    std::span<const double> times,
                                    const std::stop_token& stop);

    /// @param errors  one length a vertex, not_known where it has none
    ErrorSpread spread(const QuadComplex& mesh,
                       std::span<const VertexFunction> bounds,
                       std::span<const double> errors) const;

  private:
    bool on_border(VertexId a, VertexId b) const;

    std::vector<double> curvature_; ///< twice the mean curvature at each vertex, one over a length
    std::unordered_set<std::uint64_t> border_;
    double divergence_ = 0.0; ///< mean magnitude on the surface, one over a time
};

} // namespace wakesurf::core
