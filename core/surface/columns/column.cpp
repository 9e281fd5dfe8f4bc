#include "core/surface/columns/column.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Returns dy/dtheta of a step's dense output.
Vec3 tangent(const CurveStep& step, double theta) {
    const double other = 1.0 - theta;
    const Vec3 inner = Vec3(step.c[3]) + other * Vec3(step.c[4]);
    const Vec3 middle = Vec3(step.c[2]) + theta * inner;
    return Vec3(step.c[1]) + (other - theta) * middle +
           theta * other * (inner - theta * Vec3(step.c[4]));
}

Vec3 unit(const Vec3& v, const Vec3& otherwise) {
    const double square = glm::dot(v, v);
    return square > 0.0 ? v * (1.0 / std::sqrt(square)) : otherwise;
}

/// Returns the angle between unit vectors, in radians.
double angle(const Vec3& a, const Vec3& b) {
    return 2.0 * std::asin(std::min(0.5 * glm::length(b - a), 1.0));
}

std::size_t first_step(const Curve& curve, double start) {
    const auto after =
        std::upper_bound(curve.steps.begin(), curve.steps.end(), start,
                         [](double arc, const CurveStep& step) { return arc < step.c[0].w; });
    return after == curve.steps.begin() ? 0
                                        : static_cast<std::size_t>(after - curve.steps.begin()) - 1;
}

/// How a sheet lies at a place of a curve.
struct Frame {
    Vec3 along;       ///< of length 1
    Vec3 normal{0.0}; ///< the same, or 0 where it is not known
};

/// @param step    its number
/// @param before  what counts where there is no direction
Frame frame_at(const Curve& curve, std::size_t step, double theta, const Frame& before) {
    Frame here{unit(tangent(curve.steps[step], theta), before.along)};
    if (step < curve.stretches.size())
        here.normal = unit(glm::cross(here.along, curve.stretches[step].at(theta)), before.normal);
    return here;
}

Frame first_frame(const Curve& curve, std::size_t step) {
    return frame_at(curve, step, 0.0, {Vec3(0.0), Vec3(0.0)});
}

/// Returns the angle by which the curve or the sheet's normal turns, in radians: a sheet may twist about a
/// straight curve.
double turn_between(const Frame& a, const Frame& b) {
    const bool known = a.normal != Vec3(0.0) && b.normal != Vec3(0.0);
    return std::max(angle(a.along, b.along), known ? angle(a.normal, b.normal) : 0.0);
}

/// Returns true if any step from `first` on turns faster than `rate`, in radians a length.
bool bends(const Curve& curve, std::size_t first, double rate) {
    if (first >= curve.steps.size())
        return false;
    Frame before = first_frame(curve, first);
    for (std::size_t i = first; i < curve.steps.size(); ++i) {
        const bool last = i + 1 == curve.steps.size();
        const Frame after = frame_at(curve, i, 1.0, before);
        const double end = last ? curve.last.arc : curve.steps[i + 1].c[0].w;
        if (turn_between(before, after) > rate * (end - curve.steps[i].c[0].w))
            return true;
        before = after;
    }
    return false;
}

/// Segments that the part of a curve up to `arc` should have, not rounded.
struct Mark {
    double arc, segments;
};

std::vector<Mark>
marks_along(const Curve& curve, std::size_t first, double start, const ColumnSpacing& spacing) {
    const double straight = 1.0 / spacing.longest;
    std::vector<Mark> marks{{start, 0.0}};
    Frame before = first_frame(curve, first);
    for (std::size_t i = first; i < curve.steps.size(); ++i) {
        const CurveStep& step = curve.steps[i];
        double arc_before = step.c[0].w;
        const Frame end = frame_at(curve, i, 1.0, before);
        // A long step's turn need not be spread evenly over it.
        const double pieces =
            std::clamp(std::ceil(4.0 * turn_between(before, end) / spacing.turn), 1.0, 16.0);
        for (double piece = 1.0; piece <= pieces; ++piece) {
            const double theta = piece / pieces;
            const Frame here = frame_at(curve, i, theta, before);
            const double arc = std::min(step.at(theta).w, curve.last.arc);
            if (arc > arc_before && arc > marks.back().arc) {
                const double wanted =
                    turn_between(before, here) / (spacing.turn * (arc - arc_before));
                const double density =
                    std::clamp(wanted, straight, straight / ColumnSpacing::shortest);
                marks.push_back({arc, marks.back().segments + density * (arc - marks.back().arc)});
            }
            before = here;
            arc_before = arc;
        }
    }
    return marks;
}

} // namespace

std::vector<double> vertex_arcs(const Curve& curve, double start, const ColumnSpacing& spacing) {
    const double length = std::max(curve.last.arc - start, 0.0);
    const std::size_t first = first_step(curve, start);
    const bool any = spacing.turn >= std::numbers::pi;
    std::vector<Mark> marks;
    if (!any && length > 0.0 && bends(curve, first, spacing.turn / spacing.longest))
        marks = marks_along(curve, first, start, spacing);
    const double wanted = marks.empty() ? length / spacing.longest : marks.back().segments;
    // A last segment shorter than 1e-6 of the spacing would be a degenerate cell.
    const auto segments = static_cast<std::size_t>(std::ceil(wanted - 1e-6));
    std::vector<double> arcs;
    arcs.reserve(segments + 1);
    std::size_t at = 1;
    for (std::size_t i = 0; i < segments; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(segments);
        if (marks.empty()) {
            arcs.push_back(start + length * part);
            continue;
        }
        const double target = wanted * part;
        while (at + 1 < marks.size() && marks[at].segments < target)
            ++at;
        const Mark& low = marks[at - 1];
        const Mark& high = marks[at];
        arcs.push_back(low.arc + (high.arc - low.arc) * (target - low.segments) /
                                     (high.segments - low.segments));
    }
    arcs.push_back(segments == 0 ? start : curve.last.arc);
    return arcs;
}

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
