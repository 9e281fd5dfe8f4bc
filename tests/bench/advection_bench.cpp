#include "tests/bench/benchmarks.hpp"
#include "tests/bench/kernel/limit_kernel.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/particle_sets.hpp"
#include "tests/bench/support/sampled_flows.hpp"
#include "tests/bench/vtk/streaklines.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace wakesurf::bench {

namespace advection_bench {

constexpr int repetitions = 9;
constexpr int steps = 10; ///< in one call, which crosses one interval between time-steps

struct Case {
    const char* name;
    const SampledFlow& (*flow)();
    std::vector<core::Vec3> (*places)(const core::UniformGrid&);
    bool tangents;
    bool smooth = false;
    const SampledFlow& (*beside)() = nullptr; ///< another flow, to be as fast as
};

constexpr Case cases[] = {
    {"abc/front", sampled_abc, front_particles, false},
    {"abc/random", sampled_abc, random_particles, false},
    {"abc/front/tangents", sampled_abc, front_particles, true},
    {"abc/random/tangents", sampled_abc, random_particles, true},
    {"tornado/front", sampled_tornado, front_particles, false},
    {"tornado/random", sampled_tornado, random_particles, false},
    {"tornado/front/tangents", sampled_tornado, front_particles, true},
    {"tornado/random/tangents", sampled_tornado, random_particles, true},
    {"abc/front/rectilinear", sampled_abc_on_axes, front_particles, false, false, sampled_abc},
    {"abc/front/rectilinear/tangents", sampled_abc_on_axes, front_particles, true, false,
     sampled_abc},
    {"abc/front/smooth", sampled_abc, front_particles, false, true},
    {"abc/front/smooth/tangents", sampled_abc, front_particles, true, true},
};

/// Of the limit kernel, which carries no tangents.
double target_ratio(const Case& which) {
    return which.tangents ? 0.7 : 0.95;
}

constexpr double target_smooth_million_per_second = 4.0;
constexpr double target_times_as_long = 1.5; ///< as on the uniform grid

double carry(const SampledFlow& sampled, CarriedParticles& particles, bool smooth) {
    const core::Particles carried = particles.restart();
    core::AdvanceOptions options;
    options.method = core::AdvanceOptions::Method::Rk4;
    options.step = sampled.interval / steps;
    options.smooth = smooth;
    return on_one_core([&] {
        return seconds_of([&] {
            if (!sampled.flow->advance(carried, sampled.interval, options, {}))
                throw std::runtime_error("Flow::advance failed");
        });
    });
}

std::vector<CellPosition> in_cells(const core::UniformGrid& grid,
                                   const std::vector<core::Vec3>& places) {
    std::vector<CellPosition> cells;
    for (const core::Vec3& place : places) {
        const core::Vec3 c = (place - grid.origin) / grid.spacing;
        cells.push_back(
            {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 0.0f});
    }
    return cells;
}

/// The farthest that two contenders' particles end from each other, in cells: the check that both did the same.
double farthest(const std::vector<CellPosition>& a, const std::vector<CellPosition>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most,
                        glm::length(core::Vec3(a[i].x - b[i].x, a[i].y - b[i].y, a[i].z - b[i].z)));
    return most;
}

void measure(benchmark::State& state, const Case& which) {
    const SampledFlow& sampled = which.flow();
    CarriedParticles particles(which.places(sampled.grid), which.tangents);
    const double vertex_steps = static_cast<double>(particles.start().size()) * steps;
    const LimitField field{sampled.step(0).velocity().data(), sampled.step(1).velocity().data(),
                           sampled.grid};
    const std::vector<CellPosition> start = in_cells(sampled.grid, particles.start());
    std::vector<CellPosition> limit;
    const bool limit_runs = limit_kernel_runs_here() && !which.smooth && !which.beside;
    std::optional<VtkStreaklines> streaklines;

    std::vector<Turn> contenders{[&] { return carry(sampled, particles, which.smooth); }};
    if (limit_runs)
        contenders.push_back([&] {
            limit = start;
            return seconds_of([&] { advance_at_the_limit(field, limit, sampled.interval, steps); });
        });
    CarriedParticles others(particles.start(), which.tangents);
    if (which.beside)
        contenders.push_back([&] { return carry(which.beside(), others, which.smooth); });
    if (!which.tangents && !which.smooth &&
        !which.beside) // VTK has neither tangents nor the smooth field
        streaklines.emplace(sampled);
    for (auto _ : state) {
        const std::vector<Timed> taken = interleave(contenders, repetitions);
        state.SetIterationTime(taken[0].median);
        const double ours = 1e-6 * vertex_steps / taken[0].median;
        state.counters["million_vertex_steps_per_second"] = ours;
        state.counters["spread"] = taken[0].spread;
        if (limit_runs) {
            const double most = 1e-6 * vertex_steps / taken[1].median;
            state.counters["limit_million_per_second"] = most;
            state.counters["ratio_to_limit"] = ours / most;
            state.counters["target_ratio_to_limit"] = target_ratio(which);
            state.counters["cells_from_limit"] =
                farthest(limit, in_cells(sampled.grid, particles.position()));
        } else if (which.beside) {
            state.counters["uniform_million_per_second"] = 1e-6 * vertex_steps / taken[1].median;
            state.counters["times_as_long_as_uniform"] = taken[0].median / taken[1].median;
            state.counters["target_times_as_long"] = target_times_as_long;
            state.counters["cells_from_uniform"] =
                farthest(in_cells(sampled.grid, others.position()),
                         in_cells(sampled.grid, particles.position()));
        } else if (which.smooth) {
            state.counters["target_million_per_second"] = target_smooth_million_per_second;
        } else {
            state.SetLabel("no AVX2 and FMA here: limit kernel skipped");
        }
        if (streaklines) {
            // By itself: it sweeps the cache, and who came after it would meet another one than who came
            // before.
            const Timed alone = interleave({[&] { return streaklines->run(); }}, repetitions)[0];
            const double peer = 1e-6 * streaklines->vertex_steps() / alone.median;
            state.counters["vtk_streakline_million_per_second"] = peer;
            state.counters["ratio_to_vtk_streakline"] = ours / peer;
        }
    }
}

} // namespace advection_bench

void register_advection_benchmarks() {
    using namespace advection_bench;
    for (const Case& each : cases)
        benchmark::RegisterBenchmark((std::string("advection/") + each.name).c_str(),
                                     [each](benchmark::State& state) { measure(state, each); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
}

} // namespace wakesurf::bench
