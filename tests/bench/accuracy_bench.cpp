// The accuracy fast beside balanced, in every closed form: a fast surface has no more quads than a third above, and takes less time.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/support/surfaces_anywhere.hpp"

#include <benchmark/benchmark.h>

namespace wakesurf::bench {

namespace accuracy_bench {

constexpr double most_quads_ratio = 1.3;
constexpr double most_time_ratio = 1.0;
constexpr int surfaces = 5;

void compare(benchmark::State& state, const core::AnalyticEntry& entry, core::SurfaceKind kind) {
    on_one_core([&] {
        std::mt19937 random(16);
        std::vector<tests::AskedSurface> asked;
        for (int i = 0; i < surfaces; ++i)
            asked.push_back(tests::surface_anywhere(entry, kind, 0.05, random));
        std::size_t quads[2] = {0, 0};
        const auto contender = [&](core::Accuracy accuracy, std::size_t& count) {
            return [&asked, &count, accuracy] {
                count = 0;
                return seconds_of([&] {
                    for (tests::AskedSurface& each : asked) {
                        each.parameters.accuracy = accuracy;
                        each.parameters.max_quads = 100'000;
                        if (const auto surface = each.built())
                            count += surface->mesh.cells.size();
                    }
                });
            };
        };
        for (auto _ : state) {
            const auto timed = interleave({contender(core::Accuracy::Balanced, quads[0]),
                                           contender(core::Accuracy::Fast, quads[1])},
                                          3);
            state.counters["time_ratio"] = timed[1].median / timed[0].median;
        }
        state.counters["most_time_ratio"] = most_time_ratio;
        state.counters["quads"] = static_cast<double>(quads[1]);
        state.counters["quads_ratio"] =
            static_cast<double>(quads[1]) / static_cast<double>(std::max<std::size_t>(quads[0], 1));
        state.counters["most_quads_ratio"] = most_quads_ratio;
    });
}

} // namespace accuracy_bench

void register_accuracy_benchmarks() {
    for (const core::AnalyticEntry& entry : core::analytic_entries())
        for (const auto& [kind, word] : tests::every_kind)
            benchmark::RegisterBenchmark(
                ("fast_beside_balanced/" + std::string(entry.name) + '/' + word).c_str(),
                [&entry, kind = kind](benchmark::State& state) {
                    accuracy_bench::compare(state, entry, kind);
                })
                ->Unit(benchmark::kMillisecond)
                ->Iterations(1);
}

} // namespace wakesurf::bench
