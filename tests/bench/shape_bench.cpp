// The shape of the meshes of streak and time surfaces, on requests at random: thin cells, small angles,
// specks and holes, beside the quads and the processor time they take.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/random_requests.hpp"
#include "tests/support/mesh_shape.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <string>

namespace wakesurf::bench {

namespace shape_bench {

/// The goals, printed beside the figures.
constexpr double most_slivers_percent = 2.0;
constexpr double least_angle5 = 10.0;
constexpr double least_median = 40.0;
constexpr int repetitions = 3;

/// Several surfaces as one mesh.
struct AllCells {
    core::QuadComplex mesh;
    std::vector<bool>
        waiting; ///< on the rake: cells beside it grow from nothing, and are not judged

    void add(const core::QuadComplex& one, const core::SurfaceParameters& p) {
        const auto first = static_cast<core::VertexId>(mesh.vertices());
        mesh.position.insert(mesh.position.end(), one.position.begin(), one.position.end());
        for (const double t : one.t)
            waiting.push_back(p.kind == core::SurfaceKind::Streak && t == p.to);
        for (core::Cell cell : one.cells) {
            for (std::size_t k = 0; k < 4; ++k) {
                cell.corner[k] += first;
                cell.mid[k] += cell.mid[k] == core::no_vertex ? 0 : first;
            }
            mesh.cells.push_back(cell);
        }
    }

    tests::MeshShape shape() const {
        return tests::shape_of(mesh, [&](const core::Cell& cell) {
            return std::ranges::none_of(cell.corner, [&](core::VertexId v) { return waiting[v]; });
        });
    }
};

/// Surfaces that are too large even when coarse are left out.
AllCells built(const std::vector<RandomRequest>& requests) {
    AllCells all;
    for (const RandomRequest& each : requests) {
        core::SurfaceParameters p = each.parameters;
        p.max_quads = 100'000;
        if (const auto surface = core::build_surface(*each.flow, each.rake, p))
            all.add(surface->mesh, p);
    }
    return all;
}

void measure(benchmark::State& state, const std::vector<RandomRequest>& requests) {
    on_one_core([&] {
        AllCells all;
        const std::vector<Turn> turn{[&] { return seconds_of([&] { all = built(requests); }); }};
        for (auto _ : state)
            state.counters["seconds"] = interleave(turn, repetitions)[0].median;
        const tests::MeshShape shape = all.shape();
        state.counters["quads"] = static_cast<double>(shape.quads);
        state.counters["slivers_percent"] = 100.0 * shape.slivers;
        state.counters["angle5"] = shape.angle5;
        state.counters["median_angle"] = shape.median;
        state.counters["specks"] = static_cast<double>(shape.specks);
        state.counters["holes"] = static_cast<double>(shape.holes());
        state.counters["most_slivers_percent"] = most_slivers_percent;
        state.counters["least_angle5"] = least_angle5;
        state.counters["least_median_angle"] = least_median;
    });
}

template <class Make>
void add(const std::string& name, const Make& make) {
    benchmark::RegisterBenchmark(("shapes/" + name).c_str(),
                                 [make](benchmark::State& state) { measure(state, make()); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
}

constexpr std::array<std::pair<core::SurfaceKind, const char*>, 2> moving_kinds{
    {{core::SurfaceKind::Streak, "streak"}, {core::SurfaceKind::Time, "time"}}};

} // namespace shape_bench

void register_shape_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset) {
    using namespace shape_bench;
    for (const auto& [kind, word] : moving_kinds) {
        for (const core::AnalyticEntry& entry : core::analytic_entries())
            add(std::string(entry.name) + '/' + word,
                [&entry, kind = kind] { return random_requests(entry, kind); });
        if (dataset->info.times.size() > 1)
            add(std::string("data/") + word,
                [dataset, kind = kind] { return random_requests(dataset, kind); });
    }
}

} // namespace wakesurf::bench
