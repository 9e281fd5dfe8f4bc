#include "core/surface/circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr double round_turn = 2.0 * std::numbers::pi;

double angle_of(double turn) {
    return round_turn *
           (turn - std::floor(turn)); // the end of the circle is its beginning to the bit
}

/// Turns in 0..1 at which the circle meets the planes of the box's faces, ascending.
std::vector<double> meets_planes(const Circle& circle, const Box& box) {
    std::vector<double> turns;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = std::hypot(circle.u[axis], circle.v[axis]);
        const double middle = std::atan2(circle.v[axis], circle.u[axis]);
        for (const double plane : {box.lo[axis], box.hi[axis]}) {
            const double cosine = (plane - circle.centre[axis]) / reach;
            if (!(std::abs(cosine) < 1.0 - 1e-14)) // it passes by, or only touches
                continue;
            for (const double sign : {-1.0, 1.0}) {
                const double turn = (middle + sign * std::acos(cosine)) / round_turn;
                turns.push_back(turn - std::floor(turn));
            }
        }
    }
    std::sort(turns.begin(), turns.end());
    return turns;
}

/// An arc whose ends rounding has put outside, a little shorter.
std::optional<Arc> with_ends_inside(const Circle& circle, const Box& box, Arc arc) {
    for (double step = 1e-16; step < 0.25 * (arc[1] - arc[0]); step *= 2.0) {
        const bool first = box.contains(circle.at(arc[0]));
        const bool last = box.contains(circle.at(arc[1]));
        if (first && last)
            return arc;
        arc[0] += first ? 0.0 : step;
        arc[1] -= last ? 0.0 : step;
    }
    return std::nullopt;
}

} // namespace

Circle::Circle(const Vec3& c, const Vec3& first, const Vec3& other) : centre(c), u(first - c) {
    const Vec3 w = other - centre;
    const Vec3 across = glm::normalize(w) - u * (glm::dot(glm::normalize(w), u) / glm::dot(u, u));
    v = glm::normalize(across) * glm::length(u);
}

Vec3 Circle::at(double turn) const {
    const double angle = angle_of(turn);
    return centre + std::cos(angle) * u + std::sin(angle) * v;
}

Vec3 Circle::tangent(double turn) const {
    const double angle = angle_of(turn);
    return round_turn * (std::cos(angle) * v - std::sin(angle) * u);
}

std::optional<Arc> longest_arc_inside(const Circle& circle, const Box& box) {
    const std::vector<double> turns = meets_planes(circle, box);
    const auto inside = [&](const Arc& arc) {
        return box.contains(circle.at(0.5 * (arc[0] + arc[1])));
    };
    if (turns.empty()) // one of two may touch a face and lie outside by rounding
        return inside({0.0, 1.0}) || inside({0.0, 0.5}) ? std::optional(Arc{0.0, 1.0})
                                                        : std::nullopt;
    std::vector<Arc> pieces;
    for (std::size_t i = 0; i < turns.size(); ++i)
        pieces.push_back({turns[i], i + 1 < turns.size() ? turns[i + 1] : turns.front() + 1.0});
    // Pieces inside that follow one another are one; the row of pieces begins behind one that is outside.
    const auto outside = std::find_if_not(pieces.begin(), pieces.end(), inside);
    if (outside == pieces.end())
        return Arc{0.0, 1.0};
    const auto begun = static_cast<std::size_t>(outside - pieces.begin());
    Arc best{}, run{};
    for (std::size_t k = 1; k <= pieces.size(); ++k) {
        Arc piece = pieces[(begun + k) % pieces.size()];
        if (begun + k >= pieces.size())
            piece = {piece[0] + 1.0, piece[1] + 1.0};
        if (!inside(piece))
            run = {};
        else
            run = {run[1] > run[0] ? run[0] : piece[0], piece[1]};
        if (run[1] - run[0] > best[1] - best[0])
            best = run;
    }
    if (!(best[1] > best[0]))
        return std::nullopt;
    const double whole = std::floor(best[0]);
    return with_ends_inside(circle, box, {best[0] - whole, best[1] - whole});
}

} // namespace wakesurf::core
