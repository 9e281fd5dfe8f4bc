// A level that is dragged through a field of 128^3 values: 30 levels, each to its mesh and to its frames, with the field
// loaded once. And what loading it takes before the first.
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_surface.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "server/data/node_fields.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/quantiles.hpp"
#include "tests/support/scalar_store.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace wakesurf::bench {

namespace level_bench {

constexpr std::uint32_t nodes = 128;
constexpr int levels = 30;
constexpr double target_ms = 100.0;

core::UniformGrid cube() {
    return {core::Vec3(0.0), core::Vec3(6.0 / (nodes - 1)), {nodes, nodes, nodes}};
}

/// As a scalar that an ABC flow has carried: folded, so that a level set crosses the domain several times.
double folded(const core::Vec3& x, double) {
    return std::sin(x.x + 0.8 * std::sin(x.z)) + std::cos(x.y + 0.8 * std::sin(x.x)) + 0.3 * x.z;
}

struct Parts {
    std::vector<double> surface, encode, both, quads;
};

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

void measure(benchmark::State& state) {
    const tests::ScalarStore store(cube(), {0.0}, {{"f", folded}});
    const auto source = std::make_shared<server::NodeFields>(store.flow(), store.reader(), "U",
                                                             server::NodeFields::Options{});
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Level;
    p.field = "f";
    const auto lattice = protocol::lattice_over(cube().bounds());
    const auto one = [&](double level, Parts& parts) {
        p.level = level;
        const auto start = std::chrono::steady_clock::now();
        auto plan = core::plan_surface(store.flow(), {}, p).value();
        if (auto there = core::take_levels(plan, source); !there)
            throw std::runtime_error(there.error().message);
        const auto surface = core::build_surface(plan);
        if (!surface)
            throw std::runtime_error(surface.error().message);
        parts.surface.push_back(ms_since(start));
        const auto built = std::chrono::steady_clock::now();
        protocol::EncodeOptions encode;
        encode.final = true;
        if (const auto frames = protocol::encode_state(surface->mesh, lattice, encode); !frames)
            throw std::runtime_error(frames.error().message);
        parts.encode.push_back(ms_since(built));
        parts.both.push_back(ms_since(start));
        parts.quads.push_back(static_cast<double>(surface->mesh.cells.size()));
    };
    Parts first, parts;
    for (auto _ : state) {
        one(0.4, first);
        for (int i = 0; i < levels; ++i)
            one(-0.5 + 2.5 * i / (levels - 1), parts);
        state.SetIterationTime(quantile(parts.both, 0.5) / 1e3);
    }
    state.counters["first_ms"] = first.both.front();
    state.counters["median_ms"] = quantile(parts.both, 0.5);
    state.counters["worst_ms"] = quantile(parts.both, 1.0);
    state.counters["surface_median_ms"] = quantile(parts.surface, 0.5);
    state.counters["encode_median_ms"] = quantile(parts.encode, 0.5);
    state.counters["quads_median"] = quantile(parts.quads, 0.5);
    state.counters["target_ms"] = target_ms;
}

} // namespace level_bench

void register_level_benchmark() {
    benchmark::RegisterBenchmark("level_sets/128", level_bench::measure)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

} // namespace wakesurf::bench
