// How far what is drawn is from the exact surface, between exact vertices: flat cells, and cells on patches.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/random_requests.hpp"
#include "tests/support/drawn_surfaces.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>

namespace wakesurf::bench {

namespace tessellation_bench {

/// The goals, printed beside the figures.
constexpr double least_slope = 3.5;
constexpr double least_times_nearer = 20.0;
constexpr std::uint32_t pieces = 4;
constexpr std::size_t looked_at = 1000;

struct Both {
    tests::DrawnError curved, flat;
    double quads, flat_cells;

    explicit Both(const tests::DrawnSurface& of) {
        const std::size_t first = of.surface.mesh.vertices();
        const core::Tessellation cut = of.cut(pieces);
        curved = drawn_error(of, cut.mesh, first, looked_at);
        flat = drawn_error(of, of.cut_flat(pieces).mesh, first, looked_at);
        quads = static_cast<double>(of.surface.mesh.cells.size());
        flat_cells = static_cast<double>(cut.flat_cells);
    }
};

/// At a separation of 0.1 and at half of it.
void measure(benchmark::State& state, const tests::DrawnCase& c) {
    for (auto _ : state) {
        const std::array both{Both(tests::DrawnSurface(c, 0.1)),
                              Both(tests::DrawnSurface(c, 0.05))};
        const auto slope = [&](auto error) { return std::log2(error(both[0]) / error(both[1])); };
        state.counters["slope"] = slope([](const Both& each) { return each.curved.rms; });
        state.counters["slope_of_largest"] =
            slope([](const Both& each) { return each.curved.most; });
        state.counters["flat_slope"] = slope([](const Both& each) { return each.flat.rms; });
        state.counters["times_nearer"] = both[0].flat.rms / both[0].curved.rms;
        state.counters["times_nearer_at_most"] = both[0].flat.most / both[0].curved.most;
    }
    state.counters["least_slope"] = least_slope;
    state.counters["least_times_nearer"] = least_times_nearer;
}

/// On data the field has kinks at the faces of cells, and no order is promised. Errors in separations.
void measure_requests(benchmark::State& state, const std::vector<RandomRequest>& requests) {
    tests::DrawnError curved, flat;
    double quads = 0.0, flat_cells = 0.0;
    for (auto _ : state)
        for (const RandomRequest& each : requests) {
            core::SurfaceParameters p = each.parameters;
            p.max_quads = 20'000;
            const tests::DrawnSurface of(each.flow, each.rake, p);
            if (of.surface.mesh.cells.empty())
                continue;
            const Both both(of);
            const double per = 1.0 / of.surface.statistics.separation;
            curved.rms += std::pow(per * both.curved.rms, 2) * both.quads;
            flat.rms += std::pow(per * both.flat.rms, 2) * both.quads;
            quads += both.quads;
            flat_cells += both.flat_cells;
        }
    state.counters["flat_rms"] = std::sqrt(flat.rms / quads);
    state.counters["curved_rms"] = std::sqrt(curved.rms / quads);
    state.counters["times_nearer"] = std::sqrt(flat.rms / curved.rms);
    state.counters["quads"] = quads;
    state.counters["flat_cells"] = flat_cells;
}

} // namespace tessellation_bench

void register_tessellation_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset) {
    using namespace tessellation_bench;
    for (const tests::DrawnCase& c : tests::drawn_cases())
        benchmark::RegisterBenchmark(("tessellation/" + c.name).c_str(),
                                     [c](benchmark::State& state) { measure(state, c); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
    for (const auto& [kind, word] : tests::every_kind)
        benchmark::RegisterBenchmark((std::string("tessellation/data/") + word).c_str(),
                                     [dataset, kind = kind](benchmark::State& state) {
                                         measure_requests(state, random_requests(dataset, kind));
                                     })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
}

} // namespace wakesurf::bench
