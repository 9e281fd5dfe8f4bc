// Updates of a streak surface of 100,000 vertices, decoded by Chromium's worker.
#include "protocol/wire/mesh_stream.hpp"
#include "server/base/shipped_files.hpp"
#include "server/data/child_process.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/grown_streak.hpp"
#include "tests/bench/support/sampled_flows.hpp"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace decode_bench {

constexpr int updates = 12;
constexpr double target_million_vertices = 8.0;

/// Frames as they go over the wire, each behind its length: a KEY, then one update a step.
void write_frames(const std::filesystem::path& file) {
    const SampledFlow& sampled = sampled_slow_abc();
    const core::Rake rake{core::Rake::Kind::Line, {{0.7, 2.0, 3.0}, {5.5, 4.0, 3.5}}, 16};
    core::MovingSurface surface = grown_streak(
        *sampled.flow, rake, 0.0, static_cast<double>(SampledFlow::period) * sampled.interval);
    protocol::MeshStream stream(1, 1, protocol::lattice_over(sampled.flow->domain()));
    std::ofstream out(file, std::ios::binary);
    for (int i = 0; i <= updates; ++i) {
        const auto update = stream.next(surface.mesh(), {.phase = protocol::Phase::Live,
                                                         .tolerance = protocol::live_tolerance});
        if (!update)
            throw std::runtime_error(update.error().message);
        for (const auto& frame : update->frames) {
            const auto size = static_cast<std::uint32_t>(frame->size());
            out.write(reinterpret_cast<const char*>(&size), sizeof size);
            out.write(reinterpret_cast<const char*>(frame->data()), size);
        }
        step(surface);
    }
}

/// The web client's tools; they are only in a source tree, beside its build.
std::filesystem::path web_client() {
    return std::filesystem::weakly_canonical(server::this_program().parent_path() /
                                             "../../../web-client");
}

void measure(benchmark::State& state) {
    if (!std::filesystem::exists(web_client() / "node_modules")) {
        state.SkipWithError("needs the source tree's web-client with its npm packages (./run or "
                            "./check installs them)");
        return;
    }
    const auto file =
        std::filesystem::temp_directory_path() / ("wakesurf-frames-" + std::to_string(::getpid()));
    write_frames(file);
    for (auto _ : state) {
        nlohmann::json figures;
        const auto line = [&](std::string_view text) {
            if (text.starts_with("{"))
                figures = nlohmann::json::parse(text, nullptr, false);
        };
        const auto outcome =
            server::run_child("/usr/bin/env",
                              {"WAKESURF_FRAMES=" + file.string(), "npm", "--prefix",
                               web_client().string(), "run", "--silent", "bench:decode"},
                              0, line, {});
        if (!outcome || outcome->exit_status != 0 || !figures.is_object()) {
            state.SkipWithError(
                ("the browser run failed: " +
                 (outcome ? outcome->errors.substr(0, 200) : outcome.error().message))
                    .c_str());
            break;
        }
        state.SetIterationTime(figures["decodeMs"].get<double>() / 1e3);
        for (const char* name : {"vertices", "updates", "arraysMs", "millionVerticesPerSecond",
                                 "millionVerticesPerSecondToArrays"})
            state.counters[name] = figures[name].get<double>();
        state.counters["targetMillionVerticesPerSecond"] = target_million_vertices;
    }
    std::filesystem::remove(file);
}

} // namespace decode_bench

void register_decode_benchmark() {
    using namespace decode_bench;
    benchmark::RegisterBenchmark("decode_in_browser", measure)
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wakesurf::bench
