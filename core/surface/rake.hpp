// The rake: the widget's polyline or circle, the seeding curve it defines, and the seeds on it.
#pragma once

#include "core/base/box.hpp"
#include "core/base/result.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace wakesurf::core {

/// A circle, or an arc of it.
struct Circle {
    Vec3 centre; ///< of the circle
    Vec3 u;      ///< radius to where it begins
    Vec3 v;      ///< radius to a quarter of a turn further on

    /// Begins at `first`; `other` says which way it turns. REQUIRES: the three points do not lie on one line.
    Circle(const Vec3& centre, const Vec3& first, const Vec3& other);

    /// @param turn  0..1, once round; every point at the radius but for rounding
    Vec3 at(double turn) const;

    /// Returns the change of the place a turn, in units of length.
    Vec3 tangent(double turn) const;

    /// Returns the radius of the circle, in units of length.
    double radius() const { return glm::length(u); }
};

/// The beginning and end of an arc, in turns; the second is above 1 if the arc goes past the circle's
/// beginning. {0, 1} is the whole circle.
using Arc = std::array<double, 2>;

/// The longest part of a circle inside a box, its ends in it as well. Nothing: no part.
std::optional<Arc> longest_arc_inside(const Circle& circle, const Box& box);

/// A set of points from which particles are released.
struct Rake {
    /// The meaning of its points.
    enum class Kind { Line, Polyline, Circle, Points };
    Kind kind = Kind::Line; ///< what `points` mean
    /// The 2 points of a line, 2 or more of a polyline, the centre and two points of the rim of a circle.
    std::vector<Vec3> points;
    std::uint32_t seeds = 32; ///< how many it begins with, at least 2
    Arc arc{0.0, 1.0}; ///< circle: the part of it that releases, all of it unless clip_rake cut it

    /// A whole circle's seeding curve returns to its start, so its surface has no side edges.
    bool closed() const { return kind == Kind::Circle && arc == Arc{0.0, 1.0}; }

    bool operator==(const Rake&) const = default;
};

/// Checks what every rake has to be, wherever its surfaces may lie: the one check of rakes that are asked
/// for, kept or read from a file.
/// Error: InvalidArgument (too few or coinciding points, non-finite coordinates, fewer than 2 seeds).
Result<void> check_rake(const Rake& rake);

/// The part of a rake inside a domain.
struct ClippedRake {
    Rake rake;            ///< that part
    bool clipped = false; ///< part of the rake was outside and has been cut away
};

/// Keeps the part of a rake inside the domain: the longest, if there are several. Of a circle that is an arc
/// of the same circle, whatever arc of it the rake had. Error: InvalidArgument (too few or coinciding points,
/// non-finite coordinates, fewer than 2 seeds), OutOfDomain with the distance when nothing is inside.
Result<ClippedRake> clip_rake(const Rake& rake, const Box& domain);

/// The seeding curve c(s), s in 0..1 by arc length.
class SeedingCurve {
  public:
    /// Makes no curve yet.
    SeedingCurve() = default;
    /// Makes the curve of a rake. REQUIRES: a rake that clip_rake returns.
    explicit SeedingCurve(const Rake& rake);
    /// Returns the place there.
    Vec3 at(double s) const;

    /// Returns dc/ds, which is constant on each straight piece.
    Vec3 tangent(double s) const;

    /// A whole circle returns to its start.
    bool closed() const { return round_ && part_ == Arc{0.0, 1.0}; }

    /// Returns the length in the dataset's length unit.
    double length() const { return round_ ? round_length_ : arc_.back(); }

    /// Seed parameters, between 0 and 1, where the curve turns sharply; a circle, and an arc of one, has
    /// none.
    std::vector<double> corners() const;

  private:
    std::size_t piece(double s) const;

    double turn(double s) const { return part_[0] + s * (part_[1] - part_[0]); }

    std::vector<Vec3> points_; ///< of a polyline
    std::vector<double> arc_;  ///< length up to each of them
    std::optional<Circle> round_;
    Arc part_{0.0, 1.0};
    double round_length_ = 0.0;
};

/// Returns into how many intervals seeds part a seeding curve of `length`: no longer than `separation`, and
/// as many as the rake asks for. Where the quad budget has raised the separation above the one `requested`,
/// the rake's seeds give way: they are no closer than a quarter of it.
double seed_intervals(const Rake& rake, double length, double separation, double requested);

/// Returns the intervals of a surface whose grid stays as it is: what the rake asks for, however far apart.
double grid_intervals(const Rake& rake, double length, double separation, double requested);

/// Returns seed parameters from 0 to below 1: about `intervals` even steps, and every corner (ascending) a
/// seed, so that the surface starts at the rake's own shape.
std::vector<double> seed_parameters(const std::vector<double>& corners, double intervals);

} // namespace wakesurf::core
