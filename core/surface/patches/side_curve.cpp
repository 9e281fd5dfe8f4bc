#include "core/surface/patches/side_curve.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

template <class Visit>
void for_each_piece(const QuadComplex& mesh, const Visit& visit) {
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            const VertexId a = outline.vertex[i], b = outline.vertex[(i + 1) % outline.count];
            visit(std::min(a, b), std::max(a, b));
        }
    }
}

} // namespace

SideTable::SideTable(const QuadComplex& mesh) {
    std::vector<std::uint32_t> begin(mesh.vertices() + 1, 0);
    for_each_piece(mesh, [&](VertexId a, VertexId) { ++begin[a + 1]; });
    for (std::size_t v = 1; v < begin.size(); ++v)
        begin[v] += begin[v - 1];
    std::vector<VertexId> all(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for_each_piece(mesh, [&](VertexId a, VertexId b) { all[next[a]++] = b; });
    first_.assign(begin.size(), 0);
    for (VertexId a = 0; a < mesh.vertices(); ++a) {
        const auto from = all.begin() + begin[a], to = all.begin() + begin[a + 1];
        std::sort(from, to);
        for (auto each = from; each != to; ++each)
            if (each != from && *each == to_.back())
                ++cells_.back();
            else {
                to_.push_back(*each);
                cells_.push_back(1);
            }
        first_[a + 1] = static_cast<std::uint32_t>(to_.size());
    }
}

std::size_t SideTable::number(VertexId a, VertexId b) const {
    const VertexId low = std::min(a, b), high = std::max(a, b);
    std::size_t k = first_[low];
    while (to_[k] != high)
        ++k;
    return k;
}

namespace {

constexpr double largest_side_bulge = 0.25; ///< of the chord
constexpr double steepest = 0.6;       ///< sine of the angle between a chord and the tangent plane
constexpr double least_cosine = 0.25;  ///< of the angle between the tangent planes at both ends
constexpr double least_angle = 1e-7;   ///< sine of that between tangents that span a plane
constexpr double crease_width = 1e-12; ///< of s

/// The curve may follow these slopes.
bool tame(const Vec3& chord, const Vec3& at_a, const Vec3& at_b) {
    const double length = glm::length(chord);
    return glm::length(at_a - at_b) <= 8.0 * largest_side_bulge * length &&
           glm::length(at_a - chord) <= length && glm::length(at_b - chord) <= length;
}

} // namespace

std::optional<Vec3> unit_normal(const SurfaceTangents& tangents) {
    const Vec3 across = glm::cross(tangents.s, tangents.t);
    const double length = glm::length(across);
    if (!(length > least_angle * glm::length(tangents.s) * glm::length(tangents.t)) ||
        !std::isfinite(length))
        return std::nullopt;
    return across / length;
}

PatchPoint SideCurve::at(double part) const {
    const double rest = 1.0 - part;
    const PatchPoint chord = b - a;
    const PatchPoint straight = a + part * chord;
    if (flat)
        return straight;
    return straight + part * rest * (rest * (slope_a - chord) - part * (slope_b - chord));
}

PatchPoint SideCurve::slope(double part) const {
    const double rest = 1.0 - part;
    const PatchPoint chord = b - a;
    if (flat)
        return chord;
    return chord + rest * (rest - 2.0 * part) * (slope_a - chord) +
           part * (part - 2.0 * rest) * (slope_b - chord);
}

double SideCurves::s_between(VertexId from, VertexId to) const {
    const double way = mesh_.s[to] - mesh_.s[from];
    return closed_ ? way - std::round(way) : way;
}

bool SideCurves::on_crease(VertexId v) const {
    const auto after =
        std::lower_bound(creases_.begin(), creases_.end(), mesh_.s[v] - crease_width);
    return after != creases_.end() && *after <= mesh_.s[v] + crease_width;
}

std::optional<Vec3> SideCurves::normal(VertexId at, VertexId towards) const {
    if (!creases_.empty() && s_between(at, towards) < 0.0 && on_crease(at))
        return std::nullopt;
    return unit_normal(mesh_.tangents[at]);
}

PatchPoint SideCurves::along(VertexId at, const Vec3& direction) const {
    const SurfaceTangents& w = mesh_.tangents[at];
    const double ss = glm::dot(w.s, w.s), st = glm::dot(w.s, w.t), tt = glm::dot(w.t, w.t);
    const double s = glm::dot(direction, w.s), t = glm::dot(direction, w.t);
    const double det = ss * tt - st * st;
    return {direction, (tt * s - st * t) / det, (ss * t - st * s) / det};
}

SideCurve SideCurves::between(VertexId a, VertexId b, bool outline) const {
    SideCurve curve;
    curve.a = {mesh_.position[a], mesh_.s[a], mesh_.t[a]};
    const PatchPoint way{mesh_.position[b] - mesh_.position[a], s_between(a, b),
                         mesh_.t[b] - mesh_.t[a]};
    curve.b = curve.a + way;
    curve.slope_a = curve.slope_b = way;
    const Vec3& chord = way.position;
    const auto by_coordinates = [&](VertexId v) {
        return mesh_.tangents[v].s * way.s + mesh_.tangents[v].t * way.t;
    };
    const auto none = [&] {
        curve.slope_a = curve.slope_b = way;
        curve.flat = true;
        return curve;
    };
    const bool crease = !creases_.empty() && std::abs(way.s) <= crease_width && on_crease(a);
    const bool left_of_crease = !creases_.empty() && !crease && on_crease(way.s < 0.0 ? a : b);
    const std::optional<Vec3> normal_a = normal(a, b), normal_b = normal(b, a);
    if ((outline || crease) && !left_of_crease) {
        curve.slope_a.position = by_coordinates(a);
        curve.slope_b.position = by_coordinates(b);
        if (!finite(curve.slope_a.position) || !finite(curve.slope_b.position) ||
            !tame(chord, curve.slope_a.position, curve.slope_b.position))
            return none();
        return curve;
    }
    if ((!normal_a && !normal_b) ||
        (normal_a && normal_b && !(glm::dot(*normal_a, *normal_b) >= least_cosine)))
        return none();
    const double length = glm::length(chord);
    for (const auto& [v, plane, slope] :
         {std::tuple(a, &normal_a, &curve.slope_a), std::tuple(b, &normal_b, &curve.slope_b)}) {
        if (!*plane)
            continue;
        const double off = glm::dot(**plane, chord);
        if (!(std::abs(off) <= steepest * length))
            return none();
        *slope = PatchPoint{by_coordinates(v), way.s, way.t};
        const Vec3 in_plane = chord - off * **plane;
        if (outline)
            continue;
        // The coordinates follow, unless the tangents are so oblique that this would be another way.
        const bool near = glm::length(in_plane - slope->position) <= length;
        *slope = near ? along(v, in_plane) : PatchPoint{in_plane, way.s, way.t};
    }
    if (!normal_a)
        curve.slope_a = 2.0 * way - curve.slope_b;
    if (!normal_b)
        curve.slope_b = 2.0 * way - curve.slope_a;
    if (!tame(chord, curve.slope_a.position, curve.slope_b.position))
        return none();
    return curve;
}

} // namespace wakesurf::core
