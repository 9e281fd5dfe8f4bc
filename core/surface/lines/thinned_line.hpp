// The points of a line, as few as its turns need, and lines gathered of what was followed from seeds both ways.
#pragma once

#include "core/base/vec3.hpp"
#include "core/base/work_memory.hpp"
#include "core/integrate/curve.hpp"
#include "core/surface/lines/traced_lines.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace wakesurf::core {

/// The turn between two points of a line.
inline constexpr double turn_between = 3.0 * std::numbers::pi / 180.0;
/// Shares of the points that a curve may have at first: others need less than theirs.
inline constexpr std::size_t shares_of_curve = 4;

struct LinePoint {
    Vec3 place{0.0};
    float time = 0.0F; ///< of flight, from the seed
    float value = std::numeric_limits<float>::quiet_NaN();
};

/// What of a point is there at the end: in a curve, in the lines.
inline constexpr std::size_t line_point_bytes =
    sizeof(LinePoint) + sizeof(Vec3) + 2 * sizeof(float) + sizeof(std::uint32_t);

/// Returns the angle between two ways, from 0 to pi.
double angle_between(const Vec3& a, const Vec3& b);

/// What is followed from a seed one way.
class ThinnedLine {
  public:
    std::vector<LinePoint> points; ///< behind the seed
    bool cut = false;              ///< at the most points
    CurveEnd end = CurveEnd::Running;

    void begin(const Vec3& seed) { here_.place = seed; }

    /// Takes the next point. Returns false where the line ends there: it has the most points, or there is no memory.
    bool add(const LinePoint& next, double arc, double gap, std::size_t most, WorkMemory& memory);

    /// Takes the last point too.
    void finish(std::size_t most, WorkMemory& memory);

    Vec3 here() const { return here_.place; }

  private:
    bool keep(std::size_t most, WorkMemory& memory);

    LinePoint here_;
    Vec3 here_way_{0.0}; ///< the direction in which it came there
    Vec3 kept_way_{0.0};
    double here_arc_ = 0.0;
    double kept_arc_ = 0.0;
    bool pending_ = false; ///< `here_` is not kept yet
};

/// How many points a curve may have, where so many may be of all.
std::size_t most_of_curve(std::size_t most, std::size_t seeds, Direction direction);

/// Appends a line for each seed, its points downstream and their values, and counts why they end. The longest are cut where
/// there would be more points than may be. What was not followed one way is empty there.
void gather_lines(std::vector<ThinnedLine>& back,
                  std::vector<ThinnedLine>& forth,
                  std::span<const LinePoint> seeds,
                  Direction direction,
                  std::size_t most,
                  StreamLines& lines);

/// Finds between which values those of the lines lie.
void find_range(StreamLines& lines);

} // namespace wakesurf::core
