// A session with a small surface being edited, alone and then beside a session at its limits: 64 large surfaces on one rake
// that somebody drags.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/edited_surface.hpp"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace wakesurf::bench {

namespace fair_bench {

using nlohmann::json;

constexpr int edits = 200;
constexpr double small_quads = 2'000;
constexpr double large_quads = 200'000;
constexpr int surfaces = 64; // limits::surfaces
constexpr std::chrono::milliseconds between_drags{50};
constexpr double target_ratio = 3.0;

/// Seconds from sending each edit to the first frame of its epoch, in order of size.
std::vector<double> edit(EditedSurface& surface) {
    std::vector<double> times;
    for (int i = 0; i < edits; ++i) {
        const json before = surface.complete();
        const auto start = std::chrono::steady_clock::now();
        surface.client().send("rake.set", surface.next_edit());
        surface.until_frame_after(before["epoch"]);
        times.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    return times;
}

double part(const std::vector<double>& sorted, double part) {
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

/// Fills a session up with surfaces like its first one.
void fill(EditedSurface& heavy) {
    const json list = heavy.client().call("surface.list", json::object())["surfaces"];
    json record = list.at(0);
    json more{{"rake", record["rake"]}, {"kind", "stream"},   {"dataset", record["dataset"]},
              {"from", record["from"]}, {"to", record["to"]}, {"separation", record["separation"]},
              {"fields", json::array()}};
    for (int i = 1; i < surfaces; ++i)
        heavy.client().call("surface.set", more);
}

void measure(benchmark::State& state, const std::string& dataset) {
    const LiveServer server(dataset);
    EditedSurface light(server.address(), small_quads, 200);
    EditedSurface heavy(server.address(), large_quads);
    for (auto _ : state) {
        const auto alone = edit(light);
        fill(heavy);
        std::jthread drags([&heavy](const std::stop_token& stop) {
            while (!stop.stop_requested()) {
                heavy.client().call("rake.set", heavy.next_edit());
                std::this_thread::sleep_for(between_drags);
            }
        });
        const auto beside = edit(light);
        drags.request_stop();
        drags.join();
        state.SetIterationTime(part(beside, 0.99));
        state.counters["alone_p50_ms"] = 1e3 * part(alone, 0.5);
        state.counters["alone_p99_ms"] = 1e3 * part(alone, 0.99);
        state.counters["beside_p50_ms"] = 1e3 * part(beside, 0.5);
        state.counters["beside_p99_ms"] = 1e3 * part(beside, 0.99);
        state.counters["ratio_p99"] = part(beside, 0.99) / part(alone, 0.99);
        state.counters["target_ratio_p99"] = target_ratio;
        state.counters["heavy_quads"] = heavy.quads();
    }
}

} // namespace fair_bench

void register_fair_benchmark(const std::string& dataset) {
    using namespace fair_bench;
    benchmark::RegisterBenchmark("fair/light_beside_heavy",
                                 [dataset](benchmark::State& state) { measure(state, dataset); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wakesurf::bench
