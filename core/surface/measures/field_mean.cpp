#include "core/surface/measures/field_mean.hpp"

#include "core/surface/measures/measured.hpp"

#include <cmath>

namespace wakesurf::core {

double FieldIntegral::mean() const {
    return area > 0.0 ? value / area : not_known;
}

FieldIntegral integral_over(const QuadComplex& mesh,
                            std::span<const VertexFunction> bounds,
                            std::span<const float> values) {
    FieldIntegral out;
    visit_parts(mesh, bounds, [&](const SurfacePart& part) {
        const double area = glm::length(part.normal);
        const double share = part.moment.x + part.moment.y + part.moment.z;
        const double value = area * glm::dot(part.moment, part.at_vertices(values));
        if (!std::isfinite(value)) {
            out.unknown += area * share;
            return;
        }
        out.value += value;
        out.area += area * share;
    });
    return out;
}

} // namespace wakesurf::core
