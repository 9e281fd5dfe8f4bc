#include "core/surface/columns/column.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

Column make_column(double s, const Curve& curve, double start, const ColumnSpacing& spacing) {
    Column column;
    column.s = s;
    column.start = start;
    column.arc = vertex_arcs(curve, start, spacing);
    column.position.reserve(column.arc.size());
    column.time.reserve(column.arc.size());
    column.stretch.reserve(column.arc.size());
    CurveReader reader(curve);
    for (const double arc : column.arc) {
        const CurvePoint point = reader.at_arc(arc);
        column.position.push_back(point.position);
        column.time.push_back(point.time);
        column.stretch.push_back(point.stretch);
    }
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
