// Time-steps that come brick by brick beside whole ones: what the bricks cost where all are in memory, and what a surface takes of
// time-steps that are many times larger than the memory it has.
#include "core/dataset/brick_cache.hpp"
#include "core/field/generated_bricks.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/particle_sets.hpp"
#include "tests/support/bricked_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace bricks_bench {

using tests::BrickedSource;
using tests::SampledSource;

constexpr int repetitions = 9;
constexpr double target_times_as_long = 1.08;
constexpr double target_times_the_budget = 1.1;
constexpr double target_rounds_an_interval = 2.0;

core::Vec3 abc(const core::Vec3& p, double t) {
    const double a = 1.0 + 0.3 * std::sin(0.5 * t);
    return {a * std::sin(p.z) + std::cos(p.y), std::sin(p.x) + a * std::cos(p.z),
            std::sin(p.y) + std::cos(p.x)};
}

struct Sides {
    std::unique_ptr<core::Flow> whole, bricks;
};

std::unique_ptr<core::Flow> open(std::shared_ptr<const core::TimeStepSource> source,
                                 bool by_brick) {
    core::TimeStepCache::Options options;
    options.by_brick = by_brick;
    return core::make_stored_flow(
        std::make_shared<core::TimeStepCache>(std::move(source), options));
}

constexpr std::uint32_t nodes = 129;

core::UniformGrid cube() {
    return {core::Vec3(0.0), core::Vec3(2.0 * M_PI / (nodes - 1)), {nodes, nodes, nodes}};
}

core::Grid grid_of(bool rectilinear) {
    const core::UniformGrid grid = cube();
    if (!rectilinear)
        return grid;
    core::RectilinearGrid axes;
    for (auto& axis : axes.coordinates)
        for (std::uint32_t i = 0; i < nodes; ++i)
            axis.push_back(grid.spacing.x * i);
    return axes;
}

const Sides& sides(bool rectilinear) {
    const auto make = [](const core::Grid& grid) {
        const auto whole = std::make_shared<SampledSource>(
            grid, std::vector{0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, abc);
        return Sides{open(whole, false), open(std::make_shared<BrickedSource>(whole, 32), true)};
    };
    static const Sides uniform = make(grid_of(false));
    static const Sides stretched = make(grid_of(true));
    return rectilinear ? stretched : uniform;
}

struct Case {
    const char* name;
    std::vector<core::Vec3> (*places)(const core::UniformGrid&);
    bool tangents = false, smooth = false, rectilinear = false, series = false;
};

constexpr Case cases[] = {
    {"front", front_particles},
    {"random", random_particles},
    {"front/tangents", front_particles, true},
    {"front/smooth", front_particles, false, true},
    {"front/rectilinear", front_particles, false, false, true},
    {"front/cell_by_cell", front_particles, true, false, false, true},
};

double carry(const core::Flow& flow, CarriedParticles& particles, const Case& which) {
    const core::Particles carried = particles.restart();
    core::AdvanceOptions options;
    if (!which.series) {
        options.method = core::AdvanceOptions::Method::Rk4;
        options.step = 0.01;
    } else {
        options.method = core::AdvanceOptions::Method::Dopri5;
        options.tolerance = 1e-6;
        options.longest_step = 0.05;
    }
    options.smooth = which.smooth;
    return on_one_core([&] {
        return seconds_of([&] {
            if (const auto done = flow.advance(carried, 0.1, options, {}); !done)
                throw std::runtime_error(done.error().message);
        });
    });
}

void measure_resident(benchmark::State& state, const Case& which) {
    const Sides& both = sides(which.rectilinear);
    CarriedParticles whole(which.places(cube()), which.tangents);
    CarriedParticles bricks(which.places(cube()), which.tangents);
    for (auto _ : state) {
        const auto taken = interleave({[&] { return carry(*both.bricks, bricks, which); },
                                       [&] { return carry(*both.whole, whole, which); }},
                                      repetitions);
        if (whole.position() != bricks.position())
            throw std::runtime_error("particles end elsewhere through bricks");
        state.SetIterationTime(taken[0].median);
        state.counters["times_as_long_as_whole"] = taken[0].median / taken[1].median;
        state.counters["target_times_as_long"] = target_times_as_long;
        state.counters["spread"] = taken[0].spread;
    }
}

core::SurfaceParameters streak(const core::Flow& flow, double separation) {
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Streak;
    p.to = (*flow.time_range())[1];
    p.separation = separation;
    return p;
}

/// A streak surface in a tornado, with bricks made when they are asked for: all figures but the time are of the real pager.
void measure_beyond_memory(benchmark::State& state,
                           std::uint32_t side,
                           std::size_t budget,
                           double separation = 0.01,
                           double between_steps = 0.25) {
    std::vector<double> times;
    for (int i = 0; i < 9; ++i)
        times.push_back(between_steps * i);
    const core::UniformGrid grid{core::Vec3(0.0), core::Vec3(1.0 / (side - 1)), {side, side, side}};
    const auto source = core::GeneratedBricks::make("tornado", grid, times, 32, 2).value();
    for (auto _ : state) {
        core::TimeStepCache::Options options;
        options.budget_bytes = budget;
        const auto cache = std::make_shared<core::TimeStepCache>(source, options);
        if (!cache->bricks())
            throw std::runtime_error("the time-steps fit the budget");
        const auto flow = core::make_stored_flow(cache);
        const core::Rake rake{core::Rake::Kind::Line, {{0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}}, 16};
        const double start = thread_seconds();
        const auto surface = core::build_surface(*flow, rake, streak(*flow, separation));
        if (!surface)
            throw std::runtime_error(surface.error().message);
        state.SetIterationTime(thread_seconds() - start);
        const auto status = cache->bricks()->status();
        const double step = static_cast<double>(source->bytes_per_step());
        state.counters["quads"] = static_cast<double>(surface->mesh.cells.size());
        state.counters["time_step_in_budgets"] = step / static_cast<double>(budget);
        state.counters["most_memory_in_budgets"] =
            static_cast<double>(status.most_bytes) / static_cast<double>(budget);
        state.counters["target_most_memory"] = target_times_the_budget;
        state.counters["rounds_an_interval"] =
            static_cast<double>(status.rounds) / static_cast<double>(times.size() - 1);
        state.counters["waits_an_interval"] =
            static_cast<double>(status.waits) / static_cast<double>(times.size() - 1);
        state.counters["target_rounds"] = target_rounds_an_interval;
        state.counters["megabytes_read"] =
            1e-6 * static_cast<double>(status.reads) * 33 * 33 * 33 * 12;
    }
}

} // namespace bricks_bench

void register_bricks_benchmarks() {
    using namespace bricks_bench;
    const auto run = [](const std::string& name, auto measure) {
        benchmark::RegisterBenchmark(("bricks/" + name).c_str(), measure)
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    for (const Case& each : cases)
        run(std::string("resident/") + each.name,
            [each](benchmark::State& state) { measure_resident(state, each); });
    run("beyond_memory/512",
        [](benchmark::State& state) { measure_beyond_memory(state, 513, std::size_t{100} << 20); });
    run("beyond_memory/1024", [](benchmark::State& state) {
        measure_beyond_memory(state, 1025, std::size_t{806} << 20);
    });
    run("beyond_memory/4096", [](benchmark::State& state) {
        measure_beyond_memory(state, 4097, std::size_t{4} << 30, 0.003, 0.05);
    });
}

} // namespace wakesurf::bench
