// What a surface of 100,000 quads costs on the wire: bytes of each update beside raw floats and beside a whole Draco mesh, and the
// time to encode and to decode it on one core.
#include "protocol/wire/mesh_decoder.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/draco_mesh.hpp"
#include "tests/bench/support/grown_streak.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/one_core.hpp"
#include "tests/bench/support/sampled_flows.hpp"
#include "tests/support/held_ranges.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

namespace wakesurf::bench {

namespace wire_bench {

constexpr int updates = 12;
constexpr double raw_bytes = 16.0; ///< a vertex: float32 position and speed
constexpr double target_move_percent_of_raw = 8.0;
constexpr double target_move_percent_of_draco = 60.0;
constexpr double target_encode_million_vertices = 6.0;

/// A flow, and a rake in it whose surfaces are worth sending.
struct Scene {
    std::shared_ptr<const server::LoadedDataset> owner;
    const core::Flow* flow;
    core::Rake rake;
    double from, to;
};

Scene scene_in(std::shared_ptr<const server::LoadedDataset> dataset,
               const core::Vec3& begin,
               const core::Vec3& end,
               double to) {
    const core::Box box = dataset->flow->domain();
    const core::Rake rake{
        core::Rake::Kind::Line, {box.lo + box.extent() * begin, box.lo + box.extent() * end}, 32};
    const auto& times = dataset->info.times;
    const double from = times.empty() ? 0.0 : times.front();
    return {dataset, dataset->flow.get(), rake, from,
            times.size() > 1 ? std::min(to, times.back()) : to};
}

Scene named_scene(const std::string& name,
                  const core::Vec3& begin,
                  const core::Vec3& end,
                  double to) {
    auto loaded =
        server::resolve_dataset(name).and_then([](const server::DatasetArgument& argument) {
            return server::open_dataset(argument, {server::default_store_root(), {}},
                                        [](const store::ImportProgress&) {});
        });
    if (!loaded)
        throw std::runtime_error(loaded.error().message);
    return scene_in(std::make_shared<const server::LoadedDataset>(std::move(*loaded)), begin, end,
                    to);
}

Scene abc_scene() {
    const SampledFlow& sampled = sampled_slow_abc();
    return {nullptr,
            sampled.flow.get(),
            {core::Rake::Kind::Line, {{0.7, 2.0, 3.0}, {5.5, 4.0, 3.5}}, 16},
            0.0,
            static_cast<double>(SampledFlow::period) * sampled.interval};
}

double bytes_a_vertex(const protocol::EncodedUpdate& update) {
    return static_cast<double>(update.bytes) / static_cast<double>(update.state->vertices());
}

/// How much of a KEY says how its vertices make cells; the rest are the vertices. That is what points without cells would spare.
double cells_percent(const protocol::EncodedUpdate& key) {
    const auto frame = protocol::read_frame(*key.frames.front());
    std::size_t at = 0;
    const auto packed = protocol::take_varint(frame.value().body, at);
    return 100.0 * packed.value() / static_cast<double>(key.bytes);
}

/// Follows the updates of one stream.
struct Measured {
    protocol::MeshStream stream;
    protocol::Tolerance tolerance;
    protocol::MeshDecoder decoder{};
    double bytes = 0.0, vertices = 0.0, encode_seconds = 0.0, decode_seconds = 0.0;
    bool counting = false;
    std::optional<protocol::EncodedUpdate> newest{}; ///< of all, counted or not
    double first_bytes_a_vertex = 0.0;

    void take(const core::KeyedMesh& mesh, double count) {
        std::optional<protocol::EncodedUpdate> update;
        const double encoding = seconds_of([&] {
            auto next = stream.next(mesh, {.phase = protocol::Phase::Live, .tolerance = tolerance});
            if (!next)
                throw std::runtime_error(next.error().message);
            update = std::move(*next);
        });
        const double decoding = seconds_of([&] {
            for (const auto& frame : update->frames)
                if (const auto folded = decoder.fold(*frame); !folded)
                    throw std::runtime_error(folded.error().message);
        });
        newest = std::move(update);
        if (first_bytes_a_vertex == 0.0)
            first_bytes_a_vertex = bytes_a_vertex(*newest);
        if (!counting)
            return;
        if (newest->key)
            throw std::runtime_error("an update came as a KEY");
        bytes += static_cast<double>(newest->bytes);
        vertices += count;
        encode_seconds += encoding;
        decode_seconds += decoding;
    }
};

/// Of speed, s and t, with room for what the next steps bring.
std::vector<protocol::AttributeRange> expected_ranges(const Scene& scene,
                                                      const core::QuadComplex& mesh) {
    double fastest = 0.0;
    for (core::VertexId v = 0; v < mesh.vertices(); ++v)
        fastest = std::max(fastest, mesh.speed(v));
    return {{0.0f, static_cast<float>(1.25 * fastest)},
            {0.0f, 1.0f},
            {static_cast<float>(std::min(0.0, scene.from)), static_cast<float>(scene.to)}};
}

void measure_moves(benchmark::State& state, const std::function<Scene()>& make) {
    on_one_core([&] {
        const Scene scene = make();
        const protocol::Lattice lattice = protocol::lattice_over(scene.flow->domain());
        core::MovingSurface surface = grown_streak(*scene.flow, scene.rake, scene.from, scene.to);
        for (auto _ : state) {
            const auto ranges = expected_ranges(scene, surface.mesh().mesh);
            Measured live{tests::stream_with_ranges(lattice, ranges), protocol::live_tolerance};
            Measured exact{tests::stream_with_ranges(lattice, ranges), protocol::exact_tolerance};
            std::size_t draco = 0, draco_fine = 0;
            core::KeyedMesh before, mesh;
            double moved = 0.0, moving = 0.0;
            for (int i = 0; i < updates + 3; ++i) {
                before = std::move(mesh);
                mesh = surface.mesh();
                live.counting = exact.counting = i >= 3; // histories have filled
                const auto n = static_cast<double>(mesh.mesh.vertices());
                live.take(mesh, n);
                exact.take(mesh, n);
                if (live.counting) {
                    draco += draco_mesh_bytes(mesh.mesh, lattice, 5);
                    draco_fine += draco_mesh_bytes(mesh.mesh, lattice, 3);
                    for (std::size_t v = 0; v < before.mesh.vertices() / 2; ++v)
                        if (before.vertex_id[v] == mesh.vertex_id[v]) {
                            moved += glm::length(mesh.mesh.position[v] - before.mesh.position[v]) /
                                     lattice.step;
                            moving += 1.0;
                        }
                }
                step(surface);
            }
            state.SetIterationTime(live.encode_seconds / updates);
            state.counters["vertices"] = live.vertices / updates;
            state.counters["lattice_units_moved"] = moving > 0.0 ? moved / moving : 0.0;
            state.counters["bytes_per_vertex"] = live.bytes / live.vertices;
            state.counters["percent_of_raw"] = 100.0 * live.bytes / live.vertices / raw_bytes;
            state.counters["target_percent_of_raw"] = target_move_percent_of_raw;
            state.counters["percent_of_draco_mesh"] =
                100.0 * live.bytes / static_cast<double>(draco);
            state.counters["target_percent_of_draco_mesh"] = target_move_percent_of_draco;
            state.counters["percent_of_draco_mesh_speed_3"] =
                100.0 * live.bytes / static_cast<double>(draco_fine);
            state.counters["key_bytes_per_vertex"] = live.first_bytes_a_vertex;
            const auto late = protocol::encode_key(1, *live.newest);
            if (!late)
                throw std::runtime_error(late.error().message);
            state.counters["late_key_bytes_per_vertex"] = bytes_a_vertex(*late);
            state.counters["late_key_percent_for_cells"] = cells_percent(*late);
            state.counters["lossless_percent_of_raw"] =
                100.0 * exact.bytes / exact.vertices / raw_bytes;
            state.counters["lossless_percent_of_draco_mesh"] =
                100.0 * exact.bytes / static_cast<double>(draco);
            state.counters["encode_million_vertices_per_second"] =
                1e-6 * live.vertices / live.encode_seconds;
            state.counters["target_encode_million_vertices_per_second"] =
                target_encode_million_vertices;
            state.counters["lossless_encode_million_vertices_per_second"] =
                1e-6 * exact.vertices / exact.encode_seconds;
            state.counters["decode_million_vertices_per_second"] =
                1e-6 * live.vertices / live.decode_seconds;
        }
    });
}

void add(const std::string& name, std::function<void(benchmark::State&)> measure) {
    benchmark::RegisterBenchmark(name.c_str(), std::move(measure))
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wire_bench

void register_wire_benchmarks(std::shared_ptr<const server::LoadedDataset> dataset) {
    using namespace wire_bench;
    const std::pair<std::string, std::function<Scene()>> scenes[] = {
        {"bundled",
         [=] {
             return scene_in(dataset, {0.2, 0.35, 0.1}, {0.2, 0.65, 0.9}, 1e9);
         }},
        {"tornado",
         [] {
             return named_scene("flow:tornado", {0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}, 4.0);
         }},
        {"abc", abc_scene},
        {"double_gyre",
         [] {
             return named_scene("flow:double-gyre", {0.3, 0.2, 0.4}, {0.3, 0.8, 0.6}, 10.0);
         }},
    };
    for (const auto& [name, make] : scenes) {
        add("wire/move/" + name, [make](benchmark::State& state) { measure_moves(state, make); });
    }
}

} // namespace wakesurf::bench
