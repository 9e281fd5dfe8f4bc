// What building a surface took and gave: the shape of `--stats` and `surface.stats`.
#pragma once

#include "core/surface/surface_parameters.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::core {

struct SurfaceStatistics {
    struct Terminated { ///< columns by the reason they ended
        std::uint64_t domain = 0, time = 0, obstacle = 0, stagnation = 0, budget = 0;
    };

    struct Seconds {
        double load = 0, advect = 0, refine = 0, other = 0, total = 0;
    };

    SurfaceKind kind = SurfaceKind::Stream;
    std::uint64_t quads = 0;
    std::uint64_t vertices = 0;
    std::uint64_t steps = 0;        ///< integrator steps of the longest column
    std::uint64_t vertex_steps = 0; ///< integrator steps of all columns
    std::uint64_t approximated = 0;
    Terminated terminated;
    double max_edge = 0;
    double separation = 0;
    Seconds seconds;
    std::uint64_t peak_bytes = 0;
    std::string stopped{}; ///< why the surface ends before the time asked for; usually empty
};

} // namespace wakesurf::core
