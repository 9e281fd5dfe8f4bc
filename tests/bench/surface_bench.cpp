#include "core/surface/builder/surface_builder.hpp"
#include "tests/bench/benchmarks.hpp"

#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <vector>

namespace wakesurf::bench {

namespace surface_bench {

constexpr double wanted_quads = 20'000;
constexpr double target_ms = 150;

struct NamedRake {
    const char* name;
    core::Vec3 from, to; ///< fractions of the domain
};

/// Across the whole domain in front, in the middle and behind, and along a diagonal: smooth, torn and rolled-up sheets.
constexpr NamedRake rakes[] = {
    {"upstream", {0.094, 0.31, 0.5}, {0.094, 0.70, 0.5}},
    {"shear_layer", {0.245, 0.41, 0.05}, {0.245, 0.41, 0.97}},
    {"wake", {0.377, 0.38, 0.17}, {0.377, 0.63, 0.85}},
    {"diagonal", {0.094, 0.35, 0.1}, {0.094, 0.65, 0.9}},
};

core::SurfaceParameters
parameters(const core::DatasetInfo& info, core::SurfaceKind kind, double separation) {
    core::SurfaceParameters p;
    p.kind = kind;
    p.from = info.times.front();
    p.to = kind == core::SurfaceKind::Path ? info.times.back() : p.from + 20.0;
    p.separation = separation;
    return p;
}

/// A separation at which the surface has about the wanted number of quads.
double separation_for(const core::Flow& flow,
                      const core::DatasetInfo& info,
                      const core::Rake& rake,
                      core::SurfaceKind kind) {
    double separation = flow.finest_spacing();
    for (int i = 0; i < 12; ++i) {
        const auto surface = core::build_surface(flow, rake, parameters(info, kind, separation));
        if (!surface || surface->mesh.cells.empty())
            return 0.0;
        const double ratio = static_cast<double>(surface->mesh.cells.size()) / wanted_quads;
        if (ratio >= 1.0 && ratio < 1.03)
            break;
        separation *= std::sqrt(ratio / 1.015);
    }
    return separation;
}

/// @param separation found in the first repetition, kept for the others
void build(benchmark::State& state,
           const server::LoadedDataset& dataset,
           const NamedRake& named,
           core::SurfaceKind kind,
           double& separation) {
    const core::Box box = dataset.flow->domain();
    const core::Rake rake{core::Rake::Kind::Line,
                          {box.lo + box.extent() * named.from, box.lo + box.extent() * named.to},
                          32};
    tbb::task_arena one_core(1);
    one_core.execute([&] {
        if (separation == 0.0)
            separation = separation_for(*dataset.flow, dataset.info, rake, kind);
        if (separation == 0.0) {
            state.SkipWithError("no surface from this rake");
            return;
        }
        core::SurfaceStatistics statistics;
        for (auto _ : state) {
            const auto surface = core::build_surface(*dataset.flow, rake,
                                                     parameters(dataset.info, kind, separation));
            statistics = surface->statistics;
        }
        state.counters["quads"] = static_cast<double>(statistics.quads);
        state.counters["separation"] = separation;
        state.counters["target_ms"] = target_ms;
    });
}

} // namespace surface_bench

void register_surface_benchmarks(std::shared_ptr<const server::LoadedDataset> dataset) {
    using namespace surface_bench;
    for (const auto kind : {core::SurfaceKind::Stream, core::SurfaceKind::Path})
        for (const NamedRake& rake : rakes) {
            const std::string name =
                std::string(kind == core::SurfaceKind::Stream ? "stream" : "path") +
                "_surface_20k_quads/" + rake.name;
            const auto measure = [dataset, rake, kind, separation = std::make_shared<double>(0.0)](
                                     benchmark::State& state) {
                build(state, *dataset, rake, kind, *separation);
            };
            benchmark::RegisterBenchmark(name.c_str(), measure)
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime()
                ->Iterations(1)
                ->Repetitions(9)
                ->ReportAggregatesOnly();
        }
}

} // namespace wakesurf::bench
