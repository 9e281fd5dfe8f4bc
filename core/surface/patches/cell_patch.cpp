#include "core/surface/patches/cell_patch.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr double ridge = 1e-9; ///< of the largest diagonal element

PlaneCubics::Terms terms_at(double x, double y) {
    return {1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

PlaneCubics::Terms terms_by_x(double x, double y) {
    return {0.0, 1.0, 0.0, 2.0 * x, y, 0.0, 3.0 * x * x, 2.0 * x * y, y * y, 0.0};
}

PlaneCubics::Terms terms_by_y(double x, double y) {
    return {0.0, 0.0, 1.0, 0.0, x, 2.0 * y, 0.0, x * x, 2.0 * x * y, 3.0 * y * y};
}

PlaneValues sum(const std::array<PlaneValues, PlaneCubics::terms>& factor,
                const PlaneCubics::Terms& terms) {
    PlaneValues out(0.0);
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i)
        out += terms[i] * factor[i];
    return out;
}

} // namespace

PlaneValues PlaneCubics::value(double x, double y) const {
    return sum(factor, terms_at(x, y));
}

std::array<PlaneValues, 2> PlaneCubics::slope(double x, double y) const {
    return {sum(factor, terms_by_x(x, y)), sum(factor, terms_by_y(x, y))};
}

void PlaneCubicFit::add_value(double x, double y, const PlaneValues& value) {
    add(terms_at(x, y), value);
}

void PlaneCubicFit::add_slope(double x,
                              double y,
                              const PlaneValues& by_x,
                              const PlaneValues& by_y) {
    add(terms_by_x(x, y), by_x);
    add(terms_by_y(x, y), by_y);
}

void PlaneCubicFit::add(const PlaneCubics::Terms& row, const PlaneValues& value) {
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i) {
        right_[i] += row[i] * value;
        for (std::size_t k = 0; k <= i; ++k)
            matrix_[i][k] += row[i] * row[k];
    }
}

/// Solves by Cholesky's decomposition.
PlaneCubics PlaneCubicFit::solve() const {
    auto lower = matrix_;
    double largest = 0.0;
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i)
        largest = std::max(largest, lower[i][i]);
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i) {
        lower[i][i] += ridge * largest;
        for (std::size_t k = 0; k <= i; ++k) {
            double rest = lower[i][k];
            for (std::size_t j = 0; j < k; ++j)
                rest -= lower[i][j] * lower[k][j];
            lower[i][k] = i == k ? std::sqrt(rest) : rest / lower[k][k];
        }
    }
    PlaneCubics out;
    out.factor = right_;
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i) {
        for (std::size_t j = 0; j < i; ++j)
            out.factor[i] -= lower[i][j] * out.factor[j];
        out.factor[i] /= lower[i][i];
    }
    for (std::size_t i = PlaneCubics::terms; i-- > 0;) {
        for (std::size_t j = i + 1; j < PlaneCubics::terms; ++j)
            out.factor[i] -= lower[j][i] * out.factor[j];
        out.factor[i] /= lower[i][i];
    }
    return out;
}

namespace {

/// The values and slopes of the four sides where u and v meet them: sides 0 and 2 by u, 1 and 3 by v.
template <class Value>
struct SidesMet {
    std::array<Value, 4> value, slope;
};

/// Reads `value(k, part)` and `slope(k, part)` of side k in the direction of the outline.
template <class Value, class At, class Slope>
SidesMet<Value> sides_met(double u, double v, const At& value, const Slope& slope) {
    SidesMet<Value> met;
    met.value = {value(0, u), value(1, v), value(2, 1.0 - u), value(3, 1.0 - v)};
    met.slope = {slope(0, u), slope(1, v), -1.0 * slope(2, 1.0 - u), -1.0 * slope(3, 1.0 - v)};
    return met;
}

template <class Value>
PatchJet<Value>
blend(const std::array<Value, 4>& corner, const SidesMet<Value>& met, double u, double v) {
    const double p = 1.0 - u, q = 1.0 - v;
    const auto& [young, right, old, left] = met.value;
    const Value below = p * corner[0] + u * corner[1];
    const Value above = p * corner[3] + u * corner[2];
    return {q * young + v * old + p * left + u * right - (q * below + v * above),
            q * met.slope[0] + v * met.slope[2] + right - left -
                (q * (corner[1] - corner[0]) + v * (corner[2] - corner[3])),
            old - young + p * met.slope[3] + u * met.slope[1] - (above - below)};
}

} // namespace

PatchPoint PatchSide::at(double part) const {
    if (!mid)
        return first.at(part);
    return part < 0.5 ? first.at(2.0 * part) : second.at(2.0 * part - 1.0);
}

PatchPoint PatchSide::slope(double part) const {
    if (!mid)
        return first.slope(part);
    if (part == 0.5)
        return first.slope(1.0) + second.slope(0.0);
    return 2.0 * (part < 0.5 ? first.slope(2.0 * part) : second.slope(2.0 * part - 1.0));
}

CellPatch::CellPatch(const SideCurves& curves,
                     const Cell& cell,
                     const std::array<bool, 4>& outline) {
    // A curve is made the same way round by both of its cells, so that they have the same one to the bit.
    const auto curve = [&](VertexId a, VertexId b, bool open) {
        if (a < b)
            return curves.between(a, b, open);
        const SideCurve back = curves.between(b, a, open);
        return SideCurve{back.b, back.a, -1.0 * back.slope_b, -1.0 * back.slope_a, back.flat};
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const VertexId a = cell.corner[k], b = cell.corner[(k + 1) % 4], mid = cell.mid[k];
        PatchSide& side = side_[k];
        side.mid = mid != no_vertex;
        side.first = curve(a, side.mid ? mid : b, outline[k]);
        if (side.mid)
            side.second = curve(mid, b, outline[k]);
    }
    // Each vertex has one s, near that of the first corner: it may go round.
    if (curves.closed()) {
        const double near = curves.mesh().s[cell.corner[0]];
        for (PatchSide& side : side_)
            for (SideCurve* each : {&side.first, &side.second}) {
                const double turns = std::round(each->a.s - near);
                each->a.s -= turns;
                each->b.s -= turns;
            }
    }
    fit(curves, cell);
}

std::uint32_t CellPatch::flat_curves() const {
    std::uint32_t flat = 0;
    for (const PatchSide& side : side_)
        flat += static_cast<std::uint32_t>(side.first.flat) +
                static_cast<std::uint32_t>(side.mid && side.second.flat);
    return flat;
}

/// Lays a plane whose axes are along a diagonal and across it.
bool CellPatch::lay_plane() {
    std::array<Vec3, 4> corner;
    for (std::size_t k = 0; k < 4; ++k)
        corner[k] = side_[k].first.a.position;
    Vec3 diagonal = corner[2] - corner[0];
    const Vec3 other = corner[3] - corner[1];
    plane_.up = glm::cross(diagonal, other);
    if (glm::length(other) > glm::length(diagonal))
        diagonal = other;
    const double area = glm::length(plane_.up), length = glm::length(diagonal);
    if (!(area > 1e-6 * length * length))
        return false;
    plane_.up /= area;
    plane_.x = diagonal / length;
    plane_.y = glm::cross(plane_.up, plane_.x);
    plane_.centre = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
    double wide = 0.0, high = 0.0;
    for (const Vec3& each : corner) {
        wide = std::max(wide, std::abs(glm::dot(each - plane_.centre, plane_.x)));
        high = std::max(high, std::abs(glm::dot(each - plane_.centre, plane_.y)));
    }
    plane_.per_x = 1.0 / wide;
    plane_.per_y = 1.0 / high;
    return true;
}

/// Fits the values at a vertex, and the slopes if it has tangents.
void CellPatch::fit_vertex(PlaneCubicFit& fit,
                           const SideCurves& curves,
                           const PatchPoint& at,
                           VertexId vertex,
                           VertexId towards) const {
    const Vec3 from = at.position - plane_.centre;
    const double x = plane_.x_of(from), y = plane_.y_of(from);
    fit.add_value(x, y, {glm::dot(from, plane_.up), at.s, at.t});
    const auto normal = curves.normal(vertex, towards);
    const double up = normal ? glm::dot(*normal, plane_.up) : 0.0;
    if (!(std::abs(up) > 0.5))
        return;
    const auto along = [&](const Vec3& axis, double per) {
        const double rise = -glm::dot(*normal, axis) / up;
        const PatchPoint way = curves.along(vertex, (axis + rise * plane_.up) / per);
        return PlaneValues(rise / per, way.s, way.t);
    };
    fit.add_slope(x, y, along(plane_.x, plane_.per_x), along(plane_.y, plane_.per_y));
}

void CellPatch::fit(const SideCurves& curves, const Cell& cell) {
    if (!lay_plane())
        return;
    PlaneCubicFit fit;
    double highest = 0.0;
    const auto half_way = [&](const SideCurve& curve) {
        const PatchPoint at = curve.at(0.5);
        const Vec3 from = at.position - plane_.centre;
        const double height = glm::dot(from, plane_.up);
        fit.add_value(plane_.x_of(from), plane_.y_of(from), {height, at.s, at.t});
        highest = std::max({highest, std::abs(height),
                            std::abs(glm::dot(curve.a.position - plane_.centre, plane_.up))});
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const PatchSide& side = side_[k];
        const VertexId opposite = cell.corner[(k + 2) % 4];
        fit_vertex(fit, curves, side.first.a, cell.corner[k], opposite);
        half_way(side.first);
        if (side.mid) {
            fit_vertex(fit, curves, side.second.a, cell.mid[k], opposite);
            half_way(side.second);
        }
    }
    cubics_ = fit.solve();
    const std::array corner{side_[0].first.a, side_[1].first.a, side_[2].first.a, side_[3].first.a};
    const PatchJet<PatchPoint> middle = at(0.5, 0.5);
    const PlaneValues up = lift(middle, corner, 0.5, 0.5).value;
    const auto spread = [&](auto member) {
        return std::max(std::abs(corner[2].*member - corner[0].*member),
                        std::abs(corner[3].*member - corner[1].*member));
    };
    // Else the cell is too coarse, or its tangents too oblique, for cubics.
    lifted_ = std::abs(up.x) <= highest && std::abs(up.y) <= spread(&PatchPoint::s) &&
              std::abs(up.z) <= spread(&PatchPoint::t);
}

/// Returns what the cubics have that blending their values on the sides has not.
PatchJet<PlaneValues> CellPatch::lift(const PatchJet<PatchPoint>& base,
                                      const std::array<PatchPoint, 4>& corner,
                                      double u,
                                      double v) const {
    const auto value = [&](const PatchPoint& at) {
        const Vec3 from = at.position - plane_.centre;
        return cubics_.value(plane_.x_of(from), plane_.y_of(from));
    };
    const auto slope = [&](const PatchPoint& at, const PatchPoint& along) {
        const Vec3 from = at.position - plane_.centre;
        const auto [by_x, by_y] = cubics_.slope(plane_.x_of(from), plane_.y_of(from));
        return plane_.x_of(along.position) * by_x + plane_.y_of(along.position) * by_y;
    };
    const auto met = sides_met<PlaneValues>(
        u, v, [&](std::size_t k, double part) { return value(side_[k].at(part)); },
        [&](std::size_t k, double part) { return slope(side_[k].at(part), side_[k].slope(part)); });
    const std::array at{value(corner[0]), value(corner[1]), value(corner[2]), value(corner[3])};
    const PatchJet<PlaneValues> blended = blend(at, met, u, v);
    return {value(base.value) - blended.value, slope(base.value, base.u) - blended.u,
            slope(base.value, base.v) - blended.v};
}

PatchJet<PatchPoint> CellPatch::at(double u, double v) const {
    const std::array corner{side_[0].first.a, side_[1].first.a, side_[2].first.a, side_[3].first.a};
    const auto met = sides_met<PatchPoint>(
        u, v, [&](std::size_t k, double part) { return side_[k].at(part); },
        [&](std::size_t k, double part) { return side_[k].slope(part); });
    PatchJet<PatchPoint> point = blend(corner, met, u, v);
    if (!lifted_)
        return point;
    const PatchJet<PlaneValues> up = lift(point, corner, u, v);
    const auto add = [&](PatchPoint& to, const PlaneValues& by) {
        to = to + PatchPoint{plane_.up * by.x, by.y, by.z};
    };
    add(point.value, up.value);
    add(point.u, up.u);
    add(point.v, up.v);
    return point;
}

} // namespace wakesurf::core
