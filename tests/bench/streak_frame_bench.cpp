// Frames of an animated streak or time surface: every step carries 100,000 vertices, refines the mesh and
// releases what is due.
#include "core/base/for_each_index.hpp"
#include "core/surface/moving/moving_surface.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/division.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/sampled_flows.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace wakesurf::bench {

namespace streak_frame_bench {

constexpr int frames = 40; ///< the first touch of a time-step may fall into one of them: medians
constexpr int long_frames = 12;
constexpr double separation_in_cells = 0.3;
constexpr double target_steps_per_second = 30.0;
constexpr double target_million_vertex_steps = 5.0;
constexpr double target_two_threads = 1.8;
constexpr double target_serial_share = 0.05;

/// What a mesh should take: 200 bytes a vertex and 100 a cell.
double planned_bytes(const core::MovingMesh& mesh) {
    return 200.0 * static_cast<double>(mesh.vertices.used()) +
           100.0 * static_cast<double>(mesh.triangles.quads());
}

void step(core::MovingSurface& surface) {
    if (surface.time() == surface.end_time())
        throw std::runtime_error("the series ended before the last frame");
    if (const auto stepped = surface.step(surface.end_time(), {}); !stepped)
        throw std::runtime_error(stepped.error().message);
}

const core::Clock& steady_clock() {
    static const core::SteadyClock clock;
    return clock;
}

struct Grown {
    core::SurfaceKind kind;
    core::Accuracy accuracy;
    std::size_t vertices = 100'000;
    int lines = 1; ///< of the rake
};

/// Nearly across the cube, there and back again where it has several lines.
core::Rake rake_of(int lines) {
    core::Rake rake{lines == 1 ? core::Rake::Kind::Line : core::Rake::Kind::Polyline, {}, 16};
    for (int i = 0; i < lines; ++i) {
        const core::Vec3 aside(0.0, 0.2 * i, 0.0);
        rake.points.push_back(core::Vec3(0.7, 2.0, 3.0) + aside);
        rake.points.push_back(core::Vec3(5.5, 4.0, 3.5) + aside);
        if (i % 2 == 1)
            std::swap(rake.points.back(), rake.points[rake.points.size() - 2]);
    }
    return rake;
}

/// Moved on until it has as many vertices as wanted.
core::MovingSurface grown_surface(const Grown& asked) {
    const SampledFlow& sampled = sampled_slow_abc();
    core::SurfaceParameters p;
    p.kind = asked.kind;
    if (asked.kind == core::SurfaceKind::Time)
        p.sweep = core::Vec3(0.0, 0.0, 2.5);
    p.from = 0.0;
    p.to = static_cast<double>(SampledFlow::period) * sampled.interval;
    p.separation = separation_in_cells * sampled.spacing();
    p.accuracy = asked.accuracy;
    p.max_quads = 10 * asked.vertices;
    auto surface = core::MovingSurface::start(
        core::plan_surface(*sampled.flow, rake_of(asked.lines), p).value(), {}, steady_clock());
    if (!surface)
        throw std::runtime_error(surface.error().message);
    while (surface->state().mesh.vertices.used() < asked.vertices)
        step(*surface);
    return std::move(*surface);
}

/// What a loop costs more, in seconds, when a second thread takes part in it.
double second_thread_seconds() {
    constexpr int loops = 2000;
    const auto wall_of = [](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([] {
            return wall_seconds_of([] {
                for (int i = 0; i < loops; ++i)
                    core::for_each_index(
                        16, [](std::size_t n) { benchmark::DoNotOptimize(n); }, 1);
            });
        });
    };
    return std::max(0.0, (wall_of(2) - wall_of(1)) / loops);
}

/// How many times as fast a frame is on so many cores, if a loop costs as much more with each doubling of the threads as it
/// does for the second. Memory that cores share is left out.
double predicted(const Division& division, double cores, double second_thread) {
    const double shared = static_cast<double>(division.loops.size());
    return division.work / (division.on_cores(cores) + shared * second_thread * std::log2(cores));
}

void describe(benchmark::State& state, const core::MovingSurface& surface) {
    const core::MovingMesh& mesh = surface.state().mesh;
    state.counters["vertices"] = static_cast<double>(mesh.vertices.used());
    state.counters["cells"] = static_cast<double>(mesh.triangles.quads());
}

void measure(benchmark::State& state, const Grown& asked) {
    on_one_core([&] {
        core::MovingSurface surface = grown_surface(asked);
        for (auto _ : state) {
            const core::SurfaceStatistics before = surface.statistics();
            std::vector<double> seconds, snapshots;
            double sum = 0.0;
            Division division;
            for (int i = 0; i < frames; ++i) {
                const core::LoopTimes times;
                const double wall =
                    wall_seconds_of([&] { seconds.push_back(seconds_of([&] { step(surface); })); });
                division.add(wall, times.loops());
                sum += seconds.back();
                if (i % 8 == 0)
                    snapshots.push_back(
                        seconds_of([&] { benchmark::DoNotOptimize(surface.mesh()); }));
            }
            const core::SurfaceStatistics after = surface.statistics();
            const Timed taken = summarize(std::move(seconds));
            state.SetIterationTime(taken.median);
            state.counters["steps_per_second"] = 1.0 / taken.median;
            state.counters["target_steps_per_second"] = target_steps_per_second;
            const auto vertex_steps =
                static_cast<double>(after.vertex_steps - before.vertex_steps) / frames;
            state.counters["million_vertex_steps_per_second"] = 1e-6 * vertex_steps / taken.median;
            state.counters["target_million_vertex_steps_per_second"] = target_million_vertex_steps;
            state.counters["spread"] = taken.spread;
            // By the clock on the wall, for which other programs count, and means, not medians.
            const double advect = 1e3 * (after.seconds.advect - before.seconds.advect) / frames;
            const double refine = 1e3 * (after.seconds.refine - before.seconds.refine) / frames;
            state.counters["advect_ms"] = advect;
            state.counters["refine_ms"] = refine;
            state.counters["other_ms"] = 1e3 * sum / frames - advect - refine;
            state.counters["snapshot_ms"] = 1e3 * summarize(std::move(snapshots)).median;
            state.counters["bytes_of_planned"] =
                static_cast<double>(surface.state().bytes()) / planned_bytes(surface.state().mesh);
            state.counters["serial_ms"] = 1e3 * division.serial() / frames;
            state.counters["serial_share"] = division.serial() / division.work;
            state.counters["target_serial_share"] = target_serial_share;
            state.counters["span_ms"] =
                1e3 * division.on_cores(std::numeric_limits<double>::infinity()) / frames;
            const double second_thread = second_thread_seconds();
            state.counters["loops"] = static_cast<double>(division.loops.size()) / frames;
            state.counters["second_thread_us"] = 1e6 * second_thread;
            for (const double cores : {4.0, 16.0, 64.0}) {
                const std::string on = "_on_" + std::to_string(int(cores)) + "_cores";
                state.counters["bound" + on] = division.work / division.on_cores(cores);
                state.counters["predicted" + on] = predicted(division, cores, second_thread);
            }
            describe(state, surface);
        }
    });
}

void measure_two_threads(benchmark::State& state, const Grown& asked) {
    core::MovingSurface by_one = grown_surface(asked);
    core::MovingSurface by_two = by_one;
    tbb::task_arena one(1);
    tbb::task_arena two(2);
    Division division;
    const auto turn = [&](tbb::task_arena& arena, core::MovingSurface& surface) {
        return [&] {
            return arena.execute([&] {
                const core::LoopTimes times;
                const double wall = wall_seconds_of([&] { step(surface); });
                if (&surface == &by_one)
                    division.add(wall, times.loops());
                return wall;
            });
        };
    };
    for (auto _ : state) {
        const std::vector<Timed> taken = interleave({turn(one, by_one), turn(two, by_two)},
                                                    asked.lines == 1 ? frames : long_frames);
        state.SetIterationTime(taken[1].median);
        state.counters["steps_per_second"] = 1.0 / taken[1].median;
        state.counters["predicted_steps_per_second_on_4_cores"] =
            predicted(division, 4.0, second_thread_seconds()) / taken[0].median;
        state.counters["one_thread_ms"] = 1e3 * taken[0].median;
        state.counters["ratio_to_one_thread"] = taken[0].median / taken[1].median;
        state.counters["predicted_ratio"] = predicted(division, 2.0, second_thread_seconds());
        state.counters["target_ratio"] = target_two_threads;
        state.counters["spread"] = taken[1].spread;
        describe(state, by_two);
    }
    if (by_one.mesh().mesh.position != by_two.mesh().mesh.position)
        state.SkipWithError("two threads made another surface than one");
    else if (std::thread::hardware_concurrency() < 2)
        state.SetLabel("fewer than two cores here: the ratio says nothing");
}

void add(const std::string& name,
         const Grown& asked,
         void (*measured)(benchmark::State&, const Grown&)) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) { measured(state, asked); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace streak_frame_bench

void register_streak_frame_benchmarks() {
    using namespace streak_frame_bench;
    constexpr Grown fast{core::SurfaceKind::Streak, core::Accuracy::Fast};
    constexpr Grown balanced{core::SurfaceKind::Streak, core::Accuracy::Balanced};
    add("streak_frame/fast", fast, measure);
    add("streak_frame/balanced", balanced, measure);
    add("time_frame/balanced", {core::SurfaceKind::Time, core::Accuracy::Balanced}, measure);
    add("streak_frame/two_threads/fast", fast, measure_two_threads);
    add("streak_frame/two_threads/balanced", balanced, measure_two_threads);
    add("streak_frame/million/balanced",
        {core::SurfaceKind::Streak, core::Accuracy::Balanced, 1'000'000, 10}, measure_two_threads);
}

} // namespace wakesurf::bench
