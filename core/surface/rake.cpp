#include "core/surface/rake.hpp"

#include "core/base/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
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

namespace {

Circle circle_of(const Rake& rake) {
    return {rake.points[0], rake.points[1], rake.points[2]};
}

/// Returns the part of a segment inside a box as parameters in 0..1 (Liang and Barsky 1984); empty when lo >
/// hi.
std::array<double, 2> inside_part(const Vec3& a, const Vec3& b, const Box& box) {
    double lo = 0.0;
    double hi = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = b[axis] - a[axis];
        double enter = (box.lo[axis] - a[axis]) / d;
        double leave = (box.hi[axis] - a[axis]) / d;
        if (d == 0.0) {
            if (a[axis] < box.lo[axis] || a[axis] > box.hi[axis])
                return {1.0, 0.0};
            continue;
        }
        if (d < 0.0)
            std::swap(enter, leave);
        lo = std::max(lo, enter);
        hi = std::min(hi, leave);
    }
    return {lo, hi};
}

double distance(const Vec3& p, const Box& box) {
    return glm::length(p - glm::clamp(p, box.lo, box.hi));
}

Error outside(const std::vector<Vec3>& points, const Box& domain) {
    double nearest = distance(points.front(), domain);
    for (const Vec3& p : points)
        nearest = std::min(nearest, distance(p, domain));
    std::ostringstream text;
    text << "the rake lies outside the domain by " << nearest;
    std::ostringstream hint;
    hint << "move it into " << domain.lo.x << ".." << domain.hi.x << ", " << domain.lo.y << ".."
         << domain.hi.y << ", " << domain.lo.z << ".." << domain.hi.z;
    return {Error::Code::OutOfDomain, text.str(), hint.str()};
}

Result<ClippedRake> clip_circle(Rake rake, const Box& domain) {
    const Circle circle = circle_of(rake);
    const auto arc = longest_arc_inside(circle, domain);
    if (!arc) {
        std::vector<Vec3> points;
        for (int i = 0; i < 64; ++i)
            points.push_back(circle.at(i / 64.0));
        return tl::unexpected(outside(points, domain));
    }
    rake.arc = *arc;
    return ClippedRake{rake, !rake.closed()};
}

/// Returns why a rake is invalid, or an empty string.
std::string fault(const Rake& rake) {
    if (!std::all_of(rake.points.begin(), rake.points.end(), finite))
        return "a rake point is not finite";
    if (rake.seeds < 2)
        return "a rake needs at least 2 seeds";
    const std::size_t wanted = rake.kind == Rake::Kind::Circle ? 3 : 2;
    if (rake.points.size() < wanted || (rake.kind == Rake::Kind::Line && rake.points.size() != 2) ||
        (rake.kind == Rake::Kind::Circle && rake.points.size() != 3))
        return rake.kind == Rake::Kind::Line ? "a line rake needs exactly 2 points"
               : rake.kind == Rake::Kind::Circle
                   ? "a circle rake needs a centre and 2 points of its rim"
                   : "a rake needs at least 2 points";
    for (std::size_t i = 1; i < rake.points.size(); ++i)
        if (glm::length(rake.points[i] - rake.points[i - 1]) ==
            0.0) // 1e-320 apart is no length either
            return "two neighbouring rake points coincide";
    if (rake.kind == Rake::Kind::Circle) {
        const Vec3 u = rake.points[1] - rake.points[0];
        const Vec3 w = rake.points[2] - rake.points[0];
        if (glm::length(glm::cross(u, w)) <= 1e-9 * glm::length(u) * glm::length(w))
            return "a circle rake's centre and rim points lie on one line";
    }
    return {};
}

} // namespace

Result<void> check_rake(const Rake& rake) {
    if (const std::string reason = fault(rake); !reason.empty())
        return fail(Error::Code::InvalidArgument, reason, "correct the rake's points or seeds");
    return {};
}

Result<ClippedRake> clip_rake(const Rake& asked, const Box& domain) {
    if (auto sound = check_rake(asked); !sound)
        return tl::unexpected(sound.error());
    Rake rake = asked;
    for (Vec3& p : rake.points)
        p = onto_faces(p, domain);
    if (auto sound = check_rake(rake); !sound)
        return tl::unexpected(sound.error());
    if (rake.kind == Rake::Kind::Circle)
        return clip_circle(rake, domain);
    const std::vector<Vec3>& points = rake.points;
    if (std::all_of(points.begin(), points.end(),
                    [&](const Vec3& p) { return domain.contains(p); }))
        return ClippedRake{rake, false};
    // The longest run of the polyline inside the box; a box is convex, so a line has only one.
    std::vector<Vec3> best, run;
    double best_length = 0.0, run_length = 0.0;
    const auto finish_run = [&] {
        if (run_length > best_length)
            best = run, best_length = run_length;
        run.clear(), run_length = 0.0;
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 a = points[i - 1];
        const Vec3 b = points[i];
        const auto [lo, hi] = inside_part(a, b, domain);
        if (lo >= hi) {
            finish_run();
            continue;
        }
        if (lo > 0.0)
            finish_run();
        // Both ends of a segment that only grazes a corner may round to one point, which is no segment.
        const auto add = [&](double at) {
            const Vec3 p = glm::clamp(glm::mix(a, b, at), domain.lo, domain.hi);
            if (run.empty() || glm::length(p - run.back()) > 0.0)
                run.push_back(p);
        };
        if (run.empty())
            add(lo);
        add(hi);
        run_length += (hi - lo) * glm::length(b - a);
        if (hi < 1.0)
            finish_run();
    }
    finish_run();
    if (best.size() < 2)
        return tl::unexpected(outside(points, domain));
    const Rake::Kind kind = best.size() == 2 ? Rake::Kind::Line : Rake::Kind::Polyline;
    return ClippedRake{{kind, std::move(best), rake.seeds}, true};
}

SeedingCurve::SeedingCurve(const Rake& rake) {
    if (rake.kind == Rake::Kind::Circle) {
        round_ = circle_of(rake);
        part_ = rake.arc;
        round_length_ = 2.0 * std::numbers::pi * round_->radius() * (part_[1] - part_[0]);
        return;
    }
    points_ = rake.points;
    arc_ = {0.0};
    for (std::size_t i = 1; i < points_.size(); ++i)
        arc_.push_back(arc_.back() + glm::length(points_[i] - points_[i - 1]));
}

std::vector<double> SeedingCurve::corners() const {
    std::vector<double> found;
    for (std::size_t i = 1; i + 1 < points_.size(); ++i)
        found.push_back(arc_[i] / length());
    return found;
}

std::size_t SeedingCurve::piece(double s) const {
    const auto after = std::upper_bound(arc_.begin(), arc_.end() - 1, s * length());
    return after == arc_.begin() ? 0 : static_cast<std::size_t>(after - arc_.begin()) - 1;
}

Vec3 SeedingCurve::at(double s) const {
    if (round_)
        return round_->at(turn(std::clamp(s, 0.0, 1.0)));
    const std::size_t i = std::min(piece(s), points_.size() - 2);
    const double along = (s * length() - arc_[i]) / (arc_[i + 1] - arc_[i]);
    if (s >= 1.0)
        return points_.back();
    // A piece in a face of the domain stays there: rounding would put every other seed outside.
    const Vec3& a = points_[i];
    const Vec3& b = points_[i + 1];
    return glm::clamp(glm::mix(a, b, along), glm::min(a, b), glm::max(a, b));
}

Vec3 SeedingCurve::tangent(double s) const {
    if (round_)
        return round_->tangent(turn(s)) * (part_[1] - part_[0]);
    const std::size_t i = std::min(piece(s), points_.size() - 2);
    return (points_[i + 1] - points_[i]) * (length() / (arc_[i + 1] - arc_[i]));
}

double grid_intervals(const Rake& rake, double length, double separation, double requested) {
    double asked = rake.closed() ? rake.seeds : rake.seeds - 1.0;
    if (separation > requested)
        asked = std::min(asked, std::ceil(4.0 * length / separation));
    const double fewest = rake.closed() ? 3.0 : 1.0;
    return std::max(fewest, asked);
}

double seed_intervals(const Rake& rake, double length, double separation, double requested) {
    return std::max(grid_intervals(rake, length, separation, requested),
                    std::ceil(length / separation - 1e-9));
}

std::vector<double> seed_parameters(const std::vector<double>& corners, double intervals) {
    std::vector<double> ends{0.0};
    for (const double corner : corners)
        if (corner - ends.back() > 1e-9 && 1.0 - corner > 1e-9)
            ends.push_back(corner);
    ends.push_back(1.0);
    std::vector<double> seeds;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double width = ends[i] - ends[i - 1];
        const double pieces = std::max(1.0, std::ceil(intervals * width - 1e-9));
        for (double k = 0; k < pieces; ++k)
            seeds.push_back(ends[i - 1] + width * (k / pieces));
    }
    return seeds;
}

} // namespace wakesurf::core
