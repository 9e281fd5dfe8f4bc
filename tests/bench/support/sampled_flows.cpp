#include "tests/bench/support/sampled_flows.hpp"

#include "core/field/closed_forms.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/sampled_source.hpp"

#include <numbers>

namespace wakesurf::bench {

using core::Vec3;

namespace {

/// The same nodes, said axis by axis.
core::RectilinearGrid axes_of(const core::UniformGrid& grid) {
    core::RectilinearGrid axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        for (std::uint32_t node = 0; node < grid.dimensions[axis]; ++node)
            axes.coordinates[axis].push_back(grid.origin[i] + grid.spacing[i] * node);
    }
    return axes;
}

SampledFlow sample(double side,
                   double interval,
                   tests::SampledSource::Velocity velocity,
                   bool rectilinear = false) {
    constexpr std::uint32_t n = SampledFlow::nodes_per_side;
    SampledFlow sampled;
    sampled.grid = {Vec3(0.0), Vec3(side / (n - 1)), {n, n, n}};
    sampled.interval = interval;
    std::vector<double> times;
    for (std::size_t i = 0; i <= SampledFlow::period; ++i)
        times.push_back(static_cast<double>(i) * interval);
    const core::Grid grid =
        rectilinear ? core::Grid(axes_of(sampled.grid)) : core::Grid(sampled.grid);
    const auto source = std::make_shared<tests::SampledSource>(grid, times, std::move(velocity));
    const auto cache =
        std::make_shared<core::TimeStepCache>(source, core::TimeStepCache::Options{});
    for (std::size_t i = 0; i < times.size(); ++i)
        sampled.steps.push_back(cache->acquire(i).value());
    sampled.flow = core::make_stored_flow(cache);
    return sampled;
}

/// Phase of the series' one period.
double phase(double time, double interval) {
    return 2.0 * std::numbers::pi * time / (static_cast<double>(SampledFlow::period) * interval);
}

SampledFlow sample_abc(double interval, bool rectilinear = false) {
    const auto velocity = [interval](const Vec3& p, double t) {
        const double phi = phase(t, interval);
        const core::AbcFlow flow{1.0 + 0.3 * std::sin(phi), 0.8 + 0.3 * std::cos(phi),
                                 0.6 + 0.2 * std::sin(phi + 1.0)};
        return flow.velocity(p, t);
    };
    return sample(2.0 * std::numbers::pi, interval, velocity, rectilinear);
}

} // namespace

const SampledFlow& sampled_abc() {
    static const SampledFlow sampled = sample_abc(0.1);
    return sampled;
}

const SampledFlow& sampled_abc_on_axes() {
    static const SampledFlow sampled = sample_abc(0.1, true);
    return sampled;
}

const SampledFlow& sampled_slow_abc() {
    static const SampledFlow sampled = sample_abc(0.6);
    return sampled;
}

const SampledFlow& sampled_tornado() {
    constexpr double interval = 0.15;
    static const SampledFlow sampled = sample(1.0, interval, [](const Vec3& p, double t) {
        const double phi = phase(t, interval);
        const Vec3 drift = 0.08 * Vec3(std::sin(phi), std::cos(phi) - 1.0, 0.0);
        return core::TornadoFlow{}.velocity(p - drift, 0.0);
    });
    return sampled;
}

} // namespace wakesurf::bench
