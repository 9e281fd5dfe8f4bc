// The source of the triangles of a level set: an extractor in a process of its own, or a test's closed form.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

struct LevelWanted {
    std::string field;
    double level = 0.0;
    double time = 0.0;
    std::uint64_t most_triangles = 0;
};

/// Corners that coincide are one point, and all triangles face the same side of the level.
struct LevelTriangles {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::array<double, 2> range{0.0, 0.0}; ///< of the field's values at that time
    bool values = true;                    ///< false: it has none
    std::vector<double> times{}; ///< where it has none: those at which it has; empty: not known
};

/// Extracts level sets. Thread safety: concurrent calls are allowed.
class LevelSource {
  public:
    virtual ~LevelSource() = default;

    /// Extracts a level set from the flow's grid, without cells of which a node has no value. A level outside
    /// the range has no triangles. Error: NotFound, naming the fields there are; OverLimit (more triangles,
    /// or no memory); Cancelled; Io; what reading reports.
    virtual Result<LevelTriangles> extract(const LevelWanted& wanted,
                                           const std::stop_token& stop) const = 0;

    /// Checks that the field exists. Error: NotFound, naming the fields there are.
    virtual Result<void> check_field(const std::string& name) const = 0;
};

} // namespace wakesurf::core
