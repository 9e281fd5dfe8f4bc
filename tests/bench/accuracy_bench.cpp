// The accuracies beside each other, on the same requests at random: a balanced surface has at most 1.3 times
// the quads of an exact one and takes no longer, a fast one neither more quads nor more time than a balanced
// one.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/random_requests.hpp"

#include <benchmark/benchmark.h>

#include <array>

namespace wakesurf::bench {

namespace accuracy_bench {

constexpr double most_quads_ratio = 1.3;
constexpr double most_time_ratio = 1.0;
constexpr std::array accuracies{core::Accuracy::Exact, core::Accuracy::Balanced,
                                core::Accuracy::Fast};

/// 0 where there is none: the surface is empty, or too large even when coarse.
std::size_t quads_of(const RandomRequest& request, core::Accuracy accuracy) {
    core::SurfaceParameters p = request.parameters;
    p.accuracy = accuracy;
    p.max_quads = 100'000;
    const auto surface = core::build_surface(*request.flow, request.rake, p);
    return surface ? surface->mesh.cells.size() : 0;
}

void compare(benchmark::State& state, const std::vector<RandomRequest>& requests) {
    on_one_core([&] {
        std::array<std::size_t, accuracies.size()> quads{};
        std::vector<Turn> turns;
        for (std::size_t i = 0; i < accuracies.size(); ++i)
            turns.push_back([&, i] {
                quads[i] = 0;
                return seconds_of([&] {
                    for (const RandomRequest& each : requests)
                        quads[i] += quads_of(each, accuracies[i]);
                });
            });
        for (auto _ : state) {
            const auto timed = interleave(turns, 3);
            state.counters["balanced_time_ratio"] = timed[1].median / timed[0].median;
            state.counters["fast_time_ratio"] = timed[2].median / timed[1].median;
        }
        const auto ratio = [&](std::size_t i) {
            return static_cast<double>(quads[i]) /
                   static_cast<double>(std::max<std::size_t>(quads[i - 1], 1));
        };
        state.counters["exact_quads"] = static_cast<double>(quads[0]);
        state.counters["balanced_quads_ratio"] = ratio(1);
        state.counters["fast_quads_ratio"] = ratio(2);
        state.counters["most_time_ratio"] = most_time_ratio;
        state.counters["most_quads_ratio"] = most_quads_ratio;
    });
}

template <class Make>
void add(const std::string& name, const Make& make) {
    benchmark::RegisterBenchmark(("accuracies/" + name).c_str(),
                                 [make](benchmark::State& state) { compare(state, make()); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
}

} // namespace accuracy_bench

void register_accuracy_benchmarks(const std::shared_ptr<const server::LoadedDataset>& dataset) {
    using namespace accuracy_bench;
    for (const auto& [kind, word] : tests::every_kind) {
        for (const core::AnalyticEntry& entry : core::analytic_entries())
            add(std::string(entry.name) + '/' + word,
                [&entry, kind = kind] { return random_requests(entry, kind); });
        if (dataset->info.times.size() > 1)
            add(std::string("data/") + word,
                [dataset, kind = kind] { return random_requests(dataset, kind); });
    }
}

} // namespace wakesurf::bench
