#include "core/surface/columns/column.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

Column make_column(double s, const Curve& curve, double start, double spacing) {
    Column column;
    column.s = s;
    column.start = start;
    const double length = std::max(curve.last.arc - start, 0.0);
    // A last segment shorter than 1e-6 of the spacing would be a degenerate cell.
    const auto segments = static_cast<std::size_t>(std::ceil(length / spacing - 1e-6));
    column.position.reserve(segments + 1);
    column.arc.reserve(segments + 1);
    column.time.reserve(segments + 1);
    column.stretch.reserve(segments + 1);
    const auto append = [&](const CurvePoint& point) {
        column.position.push_back(point.position);
        column.arc.push_back(point.arc);
        column.time.push_back(point.time);
        column.stretch.push_back(point.stretch);
    };
    CurveReader reader(curve);
    for (std::size_t i = 0; i < segments; ++i)
        append(
            reader.at_arc(start + length * static_cast<double>(i) / static_cast<double>(segments)));
    append(segments == 0 ? curve.at_arc(start) : curve.last);
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
