#include "tests/bench/support/particle_sets.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace wakesurf::bench {

using core::Vec3;

std::vector<Vec3> front_particles(const core::UniformGrid& grid) {
    constexpr int side = 173;
    constexpr double turn = 2.0 * std::numbers::pi;
    std::vector<Vec3> places;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double u = static_cast<double>(i) / (side - 1);
            const double v = static_cast<double>(j) / (side - 1);
            const Vec3 fraction(0.15 + 0.7 * u,
                                0.5 + 0.2 * std::sin(2.0 * turn * u) + 0.1 * std::sin(turn * v),
                                0.15 + 0.7 * v);
            places.push_back(grid.origin + grid.bounds().extent() * fraction);
        }
    return places;
}

std::vector<Vec3> random_particles(const core::UniformGrid& grid) {
    std::mt19937_64 engine(20090526);
    const core::Box box = grid.bounds();
    const auto coordinate = [&](int axis) {
        const double margin = 8.0 * grid.spacing[axis];
        return std::uniform_real_distribution<double>(box.lo[axis] + margin,
                                                      box.hi[axis] - margin)(engine);
    };
    std::vector<Vec3> places;
    for (int i = 0; i < 30'000; ++i) {
        const double x = coordinate(0);
        const double y = coordinate(1);
        const double z = coordinate(2);
        places.emplace_back(x, y, z);
    }
    return places;
}

} // namespace wakesurf::bench
