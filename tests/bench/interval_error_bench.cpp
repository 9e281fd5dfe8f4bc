// The error between stored times as it is predicted from a series, beside the true one: closed forms that are
// stored on a grid at 8 to 64 times a period, and 512 for the truth, so that the grid is the same in both.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/quantiles.hpp"
#include "tests/support/sampled_source.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace wakesurf::bench {

namespace interval_error_bench {

using core::Vec3;
constexpr double pi = std::numbers::pi;
constexpr int dense = 512; ///< stored times a period, for the truth
constexpr double factor = 3.0;

struct StoredForm {
    const char* name;
    tests::SampledSource::Velocity velocity;
    core::UniformGrid grid;
    core::Rake rake;
    double period, end, separation;
};

core::UniformGrid grid(const Vec3& low, const Vec3& high, std::array<std::uint32_t, 3> nodes) {
    core::UniformGrid out;
    out.origin = low;
    for (int axis = 0; axis < 3; ++axis) {
        out.dimensions[static_cast<std::size_t>(axis)] = nodes[static_cast<std::size_t>(axis)];
        out.spacing[axis] = (high[axis] - low[axis]) /
                            static_cast<double>(nodes[static_cast<std::size_t>(axis)] - 1);
    }
    return out;
}

core::Rake line(const Vec3& a, const Vec3& b) {
    return {core::Rake::Kind::Line, {a, b}, 40};
}

std::vector<StoredForm> forms() {
    return {
        {"double_gyre",
         [](const Vec3& p, double t) {
             const double a = 0.25 * std::sin(2 * pi * t / 10.0), b = 1.0 - 2.0 * a;
             const double f = a * p.x * p.x + b * p.x, df = 2.0 * a * p.x + b;
             return 0.1 * pi *
                    Vec3(-std::sin(pi * f) * std::cos(pi * p.y),
                         std::cos(pi * f) * std::sin(pi * p.y) * df, 0.05);
         },
         grid({0, 0, -1}, {2, 1, 2}, {81, 41, 4}), line({0.2, 0.2, 0}, {1.8, 0.8, 0}), 10.0, 15.0,
         0.05},
        {"rotating_strain",
         [](const Vec3& p, double t) {
             const double c = std::cos(1.6 * t), s = std::sin(1.6 * t);
             return Vec3(0.5 * (c * p.x + s * p.y), 0.5 * (s * p.x - c * p.y), 0.05);
         },
         grid({-8, -8, -1}, {8, 8, 2}, {41, 41, 4}), line({-0.5, 0.1, 0}, {0.5, 0.3, 0}), pi / 0.8,
         4.0, 0.05},
        {"abc",
         [](const Vec3& p, double t) {
             const double a = std::sqrt(3.0) + 0.125 * t * std::sin(pi * t), b = std::sqrt(2.0),
                          c = 1.0 + 0.3 * std::sin(2.0 * t);
             return 0.4 * Vec3(a * std::sin(p.z) + c * std::cos(p.y),
                               b * std::sin(p.x) + a * std::cos(p.z),
                               c * std::sin(p.y) + b * std::cos(p.x));
         },
         grid({-6, -6, -6}, {10, 10, 10}, {61, 61, 61}), line({1, 2, 3}, {4, 3, 3.5}), 2.0, 5.0,
         0.1},
        {"wavy_wake",
         [](const Vec3& p, double t) {
             const double phase = 1.3 * (p.x - 0.8 * t), decay = std::exp(-p.y * p.y);
             return Vec3(1.0 + 0.3 * std::tanh(p.y / 0.3) + 0.25 * std::cos(phase) * decay,
                         0.4 * std::sin(phase) * decay,
                         0.1 * std::sin(0.7 * p.x - 2.0 * pi / 6.0 * t));
         },
         grid({-2, -4, -3}, {16, 4, 3}, {181, 81, 5}), line({0, -1, 0}, {0, 1, 0}), 2.0 * pi / 1.04,
         10.0, 0.1},
        {"orbiting_vortex", // a vortex whose core runs round in a circle
         [](const Vec3& p, double t) {
             const Vec3 core(std::cos(t), std::sin(t), 0.0);
             const double x = p.x - core.x, y = p.y - core.y, square = x * x + y * y + 0.25;
             return Vec3(-y / square, x / square, 0.1);
         },
         grid({-5, -5, -1}, {5, 5, 3}, {121, 121, 4}), line({-1.5, -0.5, 0}, {1.5, 0.5, 0}),
         2.0 * pi, 9.0, 0.1},
        {"meandering_jet",
         [](const Vec3& p, double t) {
             const double crest = 0.6 * std::sin(0.8 * p.x - 1.2 * t);
             const double sech = 1.0 / std::cosh((p.y - crest) / 0.7);
             return Vec3(sech * sech + 0.1, 0.48 * std::cos(0.8 * p.x - 1.2 * t) * sech * sech,
                         0.05 * std::cos(1.2 * t));
         },
         grid({-1, -4, -2}, {16, 4, 2}, {171, 81, 4}), line({0, -1.5, 0}, {0, 1.5, 0}),
         2.0 * pi / 1.2, 10.0, 0.1},
    };
}

std::shared_ptr<const core::Flow> stored(const StoredForm& form, int per_period) {
    std::vector<double> times;
    for (int k = 0; times.empty() || times.back() < form.end; ++k)
        times.push_back(form.period * k / per_period);
    core::TimeStepCache::Options all;
    all.budget_bytes = std::size_t{6} << 30;
    return core::make_stored_flow(std::make_shared<core::TimeStepCache>(
        std::make_shared<tests::SampledSource>(form.grid, std::move(times), form.velocity), all));
}

template <class T>
T need(core::Result<T> result) {
    if (!result)
        throw std::runtime_error(result.error().message);
    return std::move(*result);
}

/// Where the vertices of a streak surface are in the truth; not a number: not in the domain.
std::vector<Vec3>
true_places(const core::Flow& flow, const core::SurfacePlan& plan, const core::QuadComplex& mesh) {
    std::vector<Vec3> place;
    std::vector<double> time(mesh.t);
    for (const double s : mesh.s)
        place.push_back(plan.seeding.at(s));
    std::vector<core::CurveEnd> end(place.size(), core::CurveEnd::Running);
    core::AdvanceOptions options;
    options.method = core::AdvanceOptions::Method::Dopri5;
    options.tolerance = 1e-7;
    options.longest_step = flow.finest_spacing();
    need(flow.advance({place, {}, {}, time, end}, plan.parameters.to, options, {}));
    for (std::size_t i = 0; i < place.size(); ++i)
        if (end[i] != core::CurveEnd::Running)
            place[i] = Vec3(std::nan(""));
    return place;
}

/// What 99 % of the vertices are off where the series is stored at about the given interval.
double error_at(double interval,
                const StoredForm& form,
                const core::Flow& truth,
                const core::SurfaceParameters& p) {
    const int per_period = static_cast<int>(std::lround(form.period / interval));
    const auto plan = need(core::plan_surface(stored(form, std::max(per_period, 1)), form.rake, p));
    const auto mesh = need(core::build_surface(plan)).mesh;
    const auto where = true_places(truth, plan, mesh);
    std::vector<double> off;
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
        if (const double d = glm::length(where[v] - mesh.position[v]);
            mesh.approximated[v] == 0 && !std::isnan(d))
            off.push_back(d);
    return quantile(off, 0.99);
}

void predict(benchmark::State& state, const StoredForm& form) {
    for (auto _ : state) {
        const auto truth = stored(form, dense);
        for (const int per_period : {6, 8, 12, 16, 32, 64}) {
            core::SurfaceParameters p;
            p.kind = core::SurfaceKind::Streak;
            p.to = form.end;
            p.separation = form.separation;
            const auto plan = need(core::plan_surface(stored(form, per_period), form.rake, p));
            using Clock = std::chrono::steady_clock;
            const auto start = Clock::now();
            auto surface = need(core::build_surface(plan));
            const auto built = Clock::now();
            if (const auto done = core::state_interval_errors(plan, surface, {}); !done)
                throw std::runtime_error(done.error().message);
            const auto stated = Clock::now();
            const auto where = true_places(*truth, plan, surface.mesh);
            std::vector<double> predicted, real;
            std::size_t near = 0, traced = 0;
            for (std::size_t v = 0; v < surface.mesh.vertices(); ++v) {
                const double off = glm::length(where[v] - surface.mesh.position[v]);
                if (surface.mesh.approximated[v] != 0 || std::isnan(off))
                    continue;
                ++traced;
                if (std::isnan(surface.mesh.interval_error[v]))
                    continue;
                predicted.push_back(double{surface.mesh.interval_error[v]});
                real.push_back(off);
                // Nearer than this is not between stored times, but tracing.
                const double floor = 1e-4 * form.separation;
                near += std::max(predicted.back(), floor) <= factor * std::max(off, floor) &&
                        std::max(off, floor) <= factor * std::max(predicted.back(), floor);
            }
            const std::string at = "_" + std::to_string(per_period);
            state.counters["within_3" + at] =
                static_cast<double>(near) /
                static_cast<double>(std::max<std::size_t>(1, real.size()));
            state.counters["resolved" + at] = static_cast<double>(real.size()) /
                                              static_cast<double>(std::max<std::size_t>(1, traced));
            if (!real.empty()) {
                state.counters["true_p99" + at] = quantile(real, 0.99);
                state.counters["predicted_p99" + at] = quantile(predicted, 0.99);
            }
            state.counters["cost" + at] = std::chrono::duration<double>(stated - built).count() /
                                          std::chrono::duration<double>(built - start).count();
            if (const auto advised = surface.statistics.advised_interval)
                state.counters["advised_off" + at] =
                    error_at(*advised, form, *truth, p) / form.separation;
        }
        state.counters["target_within_3"] = 0.95;
        state.counters["target_cost"] = 0.6;
        state.counters["target_advised_off"] = 2.0; // and no less than half
    }
}

} // namespace interval_error_bench

void register_interval_error_benchmarks() {
    using namespace interval_error_bench;
    for (const StoredForm& form : forms())
        benchmark::RegisterBenchmark((std::string("interval_errors/") + form.name).c_str(),
                                     [form](benchmark::State& state) { predict(state, form); })
            ->Unit(benchmark::kSecond)
            ->Iterations(1);
}

} // namespace wakesurf::bench
