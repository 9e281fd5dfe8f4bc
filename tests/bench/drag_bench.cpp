#include "server/service/base/shipped_files.hpp"
#include "server/service/catalogue/child_process.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/live_server.hpp"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>

namespace wakesurf::bench {

namespace drag_bench {

constexpr double target_ms = 250;

/// The web client's tools; they are only in a source tree, beside its build.
std::filesystem::path web_client() {
    return std::filesystem::weakly_canonical(server::this_program().parent_path() /
                                             "../../../web-client");
}

void measure(benchmark::State& state, const std::string& dataset) {
    if (!std::filesystem::exists(web_client() / "node_modules")) {
        state.SkipWithError("needs the source tree's web-client with its npm packages (./run or "
                            "./check installs them)");
        return;
    }
    const LiveServer server(dataset);
    for (auto _ : state) {
        nlohmann::json figures;
        const auto line = [&](std::string_view text) {
            if (text.starts_with("{"))
                figures = nlohmann::json::parse(text, nullptr, false);
        };
        const auto outcome =
            server::run_child("/usr/bin/env",
                              {"WAKESURF_URL=" + server.address().url, "npm", "--prefix",
                               web_client().string(), "run", "--silent", "bench:drag"},
                              0, line, {});
        if (!outcome || outcome->exit_status != 0 || !figures.is_object()) {
            state.SkipWithError(
                ("the browser run failed: " +
                 (outcome ? outcome->errors.substr(0, 200) : outcome.error().message))
                    .c_str());
            return;
        }
        const double median = figures["medianMs"];
        state.SetIterationTime(median / 1e3);
        state.counters["median_ms"] = median;
        state.counters["p95_ms"] = figures["p95Ms"].get<double>();
        state.counters["samples"] = figures["samples"].get<double>();
        state.counters["quads"] = figures["quads"].get<double>();
        state.counters["target_ms"] = target_ms;
    }
}

} // namespace drag_bench

void register_drag_benchmark(const std::string& dataset) {
    using namespace drag_bench;
    benchmark::RegisterBenchmark("drag_in_browser_to_drawn_surface",
                                 [dataset](benchmark::State& state) { measure(state, dataset); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wakesurf::bench
