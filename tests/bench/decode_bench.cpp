// Updates of a streak surface of 100,000 vertices, decoded by Chromium's worker.
#include "core/surface/moving/moving_surface.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "server/service/base/shipped_files.hpp"
#include "server/service/catalogue/child_process.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/sampled_flows.hpp"

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace decode_bench {

constexpr double wanted_vertices = 100'000;
constexpr int updates = 12;
constexpr double target_million_vertices = 8.0;

void must(const core::Result<void>& done) {
    if (!done)
        throw std::runtime_error(done.error().message);
}

/// A streak surface in the slow ABC flow when nine tenths of its time are over, or when it is large enough.
core::MovingSurface streak(double separation) {
    static const core::SteadyClock clock;
    const SampledFlow& sampled = sampled_slow_abc();
    const double end = static_cast<double>(SampledFlow::period) * sampled.interval;
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Streak;
    p.from = 0.0;
    p.to = end;
    p.separation = separation;
    p.accuracy = core::Accuracy::Fast;
    const core::Rake rake{core::Rake::Kind::Line, {{0.7, 2.0, 3.0}, {5.5, 4.0, 3.5}}, 16};
    auto surface =
        core::MovingSurface::start(core::plan_surface(*sampled.flow, rake, p).value(), {}, clock);
    if (!surface)
        throw std::runtime_error(surface.error().message);
    while (surface->time() < 0.9 * end &&
           static_cast<double>(surface->state().mesh.vertices.used()) < wanted_vertices)
        must(surface->step(surface->end_time(), {}));
    return std::move(*surface);
}

core::MovingSurface large_streak() {
    double separation = 2.0 * sampled_slow_abc().spacing();
    while (true) {
        auto surface = streak(separation);
        const auto vertices = static_cast<double>(surface.state().mesh.vertices.used());
        if (vertices >= 0.9 * wanted_vertices)
            return surface;
        separation *= std::max(0.3, 0.95 * std::sqrt(vertices / wanted_vertices));
    }
}

/// Frames as they go over the wire, each behind its length: a KEY, then one update a step.
void write_frames(const std::filesystem::path& file) {
    core::MovingSurface surface = large_streak();
    protocol::MeshStream stream(1, 1, protocol::lattice_over(sampled_slow_abc().flow->domain()));
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
        must(surface.step(surface.end_time(), {}));
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
