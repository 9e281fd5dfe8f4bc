#include "tests/bench/benchmarks.hpp"
#include "tests/bench/edited_surface.hpp"
#include "tests/bench/live_server.hpp"
#include "tests/bench/support/quantiles.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <vector>

namespace wakesurf::bench {

namespace edit_bench {

using Clock = std::chrono::steady_clock;

struct Setting {
    double quads;
    int seeds;
    int edits;
    double target_p50_ms, target_p99_ms;
};

constexpr Setting large{20'000, 32, 60, 20, 0};
constexpr Setting hundred_thousand{100'000, 32, 20, 20, 0};
constexpr Setting thousand_seeds{4'000, 1000, 400, 5, 25};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// From sending an edit to holding the first frame of its epoch, the server being idle.
double edit(EditedSurface& surface) {
    const std::uint32_t before = surface.complete()["epoch"];
    const auto start = Clock::now();
    surface.client().send("rake.set", surface.next_edit());
    surface.until_frame_after(before);
    return seconds_since(start);
}

/// From sending an edit to the whole surface, on the server: no picture of its points comes sooner than they are all traced.
double edit_to_whole(EditedSurface& surface) {
    surface.complete();
    const auto start = Clock::now();
    surface.client().send("rake.set", surface.next_edit());
    surface.complete();
    return seconds_since(start);
}

/// The same, with the server in the middle of the previous edit's surface.
double edit_while_busy(EditedSurface& surface) {
    const std::uint32_t before = surface.complete()["epoch"];
    surface.client().send("rake.set", surface.next_edit());
    surface.until_frame_after(before); // the coarse surface is out, the fine one is being computed
    const auto start = Clock::now();
    surface.client().send("rake.set", surface.next_edit());
    surface.until_frame_after(before + 1);
    return seconds_since(start);
}

void measure(benchmark::State& state,
             const std::string& dataset,
             const Setting& setting,
             double (*one)(EditedSurface&)) {
    const LiveServer server({dataset, "--log-level", "error"});
    EditedSurface surface(server.address(), setting.quads, setting.seeds);
    std::vector<double> times;
    for (auto _ : state) {
        times.push_back(one(surface));
        state.SetIterationTime(times.back());
    }
    state.counters["p50_ms"] = 1e3 * quantile(times, 0.5);
    state.counters["p95_ms"] = 1e3 * quantile(times, 0.95);
    state.counters["p99_ms"] = 1e3 * quantile(times, 0.99);
    state.counters["quads"] = surface.quads();
    if (setting.target_p50_ms > 0)
        state.counters["target_p50_ms"] = setting.target_p50_ms;
    if (setting.target_p99_ms > 0)
        state.counters["target_p99_ms"] = setting.target_p99_ms;
}

} // namespace edit_bench

void register_edit_benchmark(const std::string& dataset) {
    using namespace edit_bench;
    const auto add = [&](const char* name, const Setting& setting, double (*one)(EditedSurface&)) {
        benchmark::RegisterBenchmark(name,
                                     [dataset, setting, one](benchmark::State& state) {
                                         measure(state, dataset, setting, one);
                                     })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(setting.edits);
    };
    add("edit_to_first_frame/idle", large, edit);
    add("edit_to_first_frame/busy", large, edit_while_busy);
    add("edit_to_first_frame/1000_seeds", thousand_seeds, edit);
    add("edit_to_first_frame/100000_quads", hundred_thousand, edit);
    add("edit_to_whole_surface/100000_quads", {100'000, 32, 20, 0, 0}, edit_to_whole);
}

} // namespace wakesurf::bench
