// What a quad budget costs that a surface has to be coarser for: its time beside that of the surface at the separation it ended with, and
// how much of the budget it has.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <benchmark/benchmark.h>

namespace wakesurf::bench {

namespace budget_bench {

constexpr std::uint64_t budget = 5'000;
constexpr double least_share = 0.7;
constexpr double most_time_ratio = 2.0;
constexpr int surfaces = 3;

void compare(benchmark::State& state, const core::AnalyticEntry& entry, core::SurfaceKind kind) {
    on_one_core([&] {
        std::mt19937 random(16);
        std::vector<tests::AskedSurface> asked, direct;
        double share = 1.0;
        for (int i = 0; i < surfaces; ++i) {
            tests::AskedSurface each = tests::surface_anywhere(entry, kind, 0.002, random);
            each.parameters.max_quads = budget;
            const auto built = each.built();
            if (!built || !built->statistics.coarsened() || built->mesh.cells.empty())
                continue;
            share = std::min(share, static_cast<double>(built->mesh.cells.size()) /
                                        static_cast<double>(budget));
            tests::AskedSurface same{*core::make_analytic_flow(std::string(entry.name)), each.rake,
                                     each.parameters};
            same.parameters.separation = built->statistics.separation;
            same.parameters.max_quads = 100 * budget;
            asked.push_back(std::move(each));
            direct.push_back(std::move(same));
        }
        const auto contender = [](const std::vector<tests::AskedSurface>& all) {
            return [&all] {
                return seconds_of([&] {
                    for (const tests::AskedSurface& each : all)
                        benchmark::DoNotOptimize(each.built());
                });
            };
        };
        for (auto _ : state) {
            const auto timed = interleave({contender(direct), contender(asked)}, 3);
            state.counters["time_ratio"] = asked.empty() ? 0.0 : timed[1].median / timed[0].median;
        }
        state.counters["most_time_ratio"] = most_time_ratio;
        state.counters["surfaces"] = static_cast<double>(asked.size());
        state.counters["share"] = share;
        state.counters["least_share"] = least_share;
    });
}

} // namespace budget_bench

void register_budget_benchmarks() {
    for (const core::AnalyticEntry& entry : core::analytic_entries())
        for (const auto& [kind, word] : tests::every_kind)
            benchmark::RegisterBenchmark(
                ("quad_budget/" + std::string(entry.name) + '/' + word).c_str(),
                [&entry, kind = kind](benchmark::State& state) {
                    budget_bench::compare(state, entry, kind);
                })
                ->Unit(benchmark::kMillisecond)
                ->Iterations(1);
}

} // namespace wakesurf::bench
