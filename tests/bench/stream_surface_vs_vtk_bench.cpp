#include "core/surface/builder/surface_builder.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/division.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/vtk/stream_surface.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>

namespace wakesurf::bench {

namespace stream_surface_vs_vtk_bench {

constexpr int repetitions = 5;

/// Beyond it VTK's lines reach the cylinder where the tornado turns round; each step then doubles its front.
constexpr double arc_in_cells = 152.0;

/// Beside the axis, and along it from the foot to the middle: a roll that grows to one and a half times the rake's length.
core::Rake rake(std::uint32_t seeds) {
    return {core::Rake::Kind::Line, {{0.61, 0.63, 0.05}, {0.44, 0.52, 0.5}}, seeds};
}

struct Size {
    const char* name;
    std::uint32_t vtk_seeds;
    double vtk_step; ///< cells
};

constexpr Size sizes[] = {{"85k_quads/200_seeds_1.0_cell", 200, 1.0},
                          {"330k_quads/50_seeds_0.5_cell", 50, 0.5},
                          {"330k_quads/200_seeds_0.5_cell", 200, 0.5}};

/// One size: VTK's surface, and ours made to match it.
struct Match {
    VtkStreamSurface vtk;
    Triangles vtk_result;
    core::SurfaceParameters parameters;
    core::QuadComplex result;

    double vtk_quads() const { return 0.5 * static_cast<double>(vtk_result.corner.size()); }

    double quads() const { return static_cast<double>(result.cells.size()); }
};

core::QuadComplex build(const core::SurfaceParameters& parameters) {
    auto surface = core::build_surface(*sampled_tornado().flow, rake(32), parameters);
    if (!surface)
        throw std::runtime_error(surface.error().message);
    return std::move(surface->mesh);
}

double area(const core::QuadComplex& mesh) {
    double sum = 0.0;
    for (const core::Cell& cell : mesh.cells) {
        const auto at = [&](std::size_t i) { return mesh.position[cell.corner[i]]; };
        sum += 0.5 * glm::length(glm::cross(at(2) - at(0), at(3) - at(1)));
    }
    return sum;
}

/// The integration time at which our surface is as large as VTK's, whose fronts are of equal arc length and not time.
double time_for(double wanted, core::SurfaceParameters parameters) {
    parameters.separation = 2.0 * sampled_tornado().spacing(); // area hardly depends on it
    double low = 0.0, high = 1.0;
    const auto smaller = [&](double time) {
        parameters.to = time;
        return area(build(parameters)) < wanted;
    };
    while (smaller(high) && high < 64.0)
        high *= 2.0;
    for (int i = 0; i < 12; ++i) {
        const double middle = 0.5 * (low + high);
        (smaller(middle) ? low : high) = middle;
    }
    return high;
}

Match match(const Size& size) {
    Match m;
    m.vtk = {&sampled_tornado(), rake(size.vtk_seeds), size.vtk_step, arc_in_cells};
    m.vtk.build(&m.vtk_result);
    m.parameters.kind = core::SurfaceKind::Stream;
    m.parameters.max_quads = 10'000'000;
    m.parameters.to = time_for(m.vtk_result.area(), m.parameters);
    // With 50 seeds the edges of the rake itself are the longest by far, which would make it too easy.
    const double longest =
        std::min(m.vtk_result.longest_side(), 1.1 * size.vtk_step * sampled_tornado().spacing());
    m.parameters.separation = longest;
    for (int i = 0; i < 4; ++i) {
        m.result = build(m.parameters);
        const double ours = core::longest_edge(m.result);
        if (ours <= longest && ours > 0.97 * longest)
            break;
        m.parameters.separation *= 0.985 * longest / ours;
    }
    m.result = build(m.parameters);
    return m;
}

const std::vector<Match>& matches() {
    static const std::vector<Match> all = [] {
        std::vector<Match> made;
        for (const Size& size : sizes)
            made.push_back(match(size));
        return made;
    }();
    return all;
}

struct Times {
    Timed ours, vtk;
};

/// What two threads can share of making our surface, several times.
Division division_of(const Match& m) {
    return on_one_core([&] {
        Division division;
        for (int i = 0; i < repetitions; ++i) {
            const core::LoopTimes times;
            const double wall = wall_seconds_of([&] { build(m.parameters); });
            division.add(wall, times.loops());
        }
        return division;
    });
}

/// All sizes of both contenders in turn, so that growth is a ratio of neighbours in time as well.
const std::vector<Times>& times() {
    static const std::vector<Times> all = [] {
        std::vector<Turn> turns;
        for (const Match& m : matches()) {
            turns.push_back([&m] {
                return on_one_core([&] { return seconds_of([&] { build(m.parameters); }); });
            });
            turns.push_back([&m] { return m.vtk.build(); });
        }
        const std::vector<Timed> taken = interleave(turns, repetitions);
        std::vector<Times> pairs;
        for (std::size_t i = 0; i < taken.size(); i += 2)
            pairs.push_back({taken[i], taken[i + 1]});
        return pairs;
    }();
    return all;
}

void measure_time(benchmark::State& state, std::size_t which) {
    for (auto _ : state) {
        const Match& m = matches()[which];
        const double seconds = times()[which].ours.median;
        const double vtk_seconds = times()[which].vtk.median;
        const double cell = sampled_tornado().spacing();
        state.SetIterationTime(seconds);
        state.counters["quads"] = m.quads();
        state.counters["vtk_quads"] = m.vtk_quads();
        state.counters["seconds"] = seconds;
        state.counters["vtk_seconds"] = vtk_seconds;
        state.counters["spread"] = times()[which].ours.spread;
        state.counters["times_faster"] = vtk_seconds / seconds;
        state.counters["times_faster_per_quad"] =
            m.quads() / seconds / (m.vtk_quads() / vtk_seconds);
        state.counters["thousand_quads_per_second"] = 1e-3 * m.quads() / seconds;
        state.counters["vtk_thousand_quads_per_second"] = 1e-3 * m.vtk_quads() / vtk_seconds;
        state.counters["longest_edge_cells"] = core::longest_edge(m.result) / cell;
        state.counters["vtk_longest_edge_cells"] = m.vtk_result.longest_side() / cell;
        state.counters["area_cells"] = area(m.result) / (cell * cell);
        state.counters["vtk_area_cells"] = m.vtk_result.area() / (cell * cell);
        const Division division = division_of(m);
        state.counters["serial_share"] = division.serial() / division.work;
        state.counters["bound_on_2_cores"] = division.work / division.on_cores(2.0);
        if (which > 0) {
            const Match& small = matches()[0];
            state.counters["quads_growth"] = m.quads() / small.quads();
            state.counters["time_growth"] = seconds / times()[0].ours.median;
            state.counters["vtk_quads_growth"] = m.vtk_quads() / small.vtk_quads();
            state.counters["vtk_time_growth"] = vtk_seconds / times()[0].vtk.median;
        }
    }
}

} // namespace stream_surface_vs_vtk_bench

void register_stream_surface_benchmarks() {
    using namespace stream_surface_vs_vtk_bench;
    for (std::size_t i = 0; i < std::size(sizes); ++i)
        benchmark::RegisterBenchmark(
            (std::string("stream_surface_vs_vtk/time/") + sizes[i].name).c_str(),
            [i](benchmark::State& state) { measure_time(state, i); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
}

} // namespace wakesurf::bench
