#include "core/surface/columns/column.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

Column make_column(double s, const Curve& curve, double start, double spacing) {
    Column column{s, {}};
    const double length = std::max(curve.last.arc - start, 0.0);
    // A last segment shorter than 1e-6 of the spacing would be a degenerate cell.
    const auto segments = static_cast<std::size_t>(std::ceil(length / spacing - 1e-6));
    column.points.reserve(segments + 1);
    for (std::size_t i = 0; i < segments; ++i)
        column.points.push_back(
            curve.at_arc(start + length * static_cast<double>(i) / static_cast<double>(segments)));
    column.points.push_back(segments == 0 ? curve.at_arc(start) : curve.last);
    return column;
}

double nearest_arc(const Curve& curve, const Vec3& target, double guess, double reach) {
    const double low = std::max(guess - reach, 0.0);
    const double high = std::min(guess + reach, curve.last.arc);
    double arc = std::clamp(guess, low, std::max(low, high));
    const double small = 1e-3 * reach;
    for (int i = 0; i < 4; ++i) {
        const Vec3 here = curve.at_arc(arc).position;
        const Vec3 along = curve.at_arc(arc + small).position - curve.at_arc(arc - small).position;
        const double length = glm::length(along);
        if (length == 0.0)
            break;
        arc = std::clamp(arc + glm::dot(target - here, along) / length, low, std::max(low, high));
    }
    return arc;
}

} // namespace wakesurf::core
