// Particles to be carried, with the results that Flow::advance fills in.
#pragma once

#include "core/integrate/particles.hpp"

#include <random>
#include <vector>

namespace wakesurf::tests {

struct PlainSwarm {
    std::vector<core::Vec3> position;
    std::vector<double> time;
    std::vector<core::CurveEnd> end;

    PlainSwarm(std::vector<core::Vec3> at, double start)
        : position(std::move(at)), time(position.size(), start),
          end(position.size(), core::CurveEnd::Running) {}

    core::Particles particles() { return {position, {}, {}, time, end}; }
};

inline std::vector<core::Vec3>
random_points(const core::Box& box, std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<core::Vec3> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(box.lo +
                         box.extent() * core::Vec3(unit(random), unit(random), unit(random)));
    return points;
}

} // namespace wakesurf::tests
