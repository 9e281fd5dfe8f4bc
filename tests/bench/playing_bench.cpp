// A streak surface playing through a series that does not fit the cache, beside the same surface with all of it in memory: what
// is left of the speed shows how well loading hides behind computing. The files are in the page cache.
#include "core/surface/moving/moving_surface.hpp"
#include "server/service/catalogue/open_dataset.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/support/temporary_store.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <stdexcept>

namespace wakesurf::bench {

namespace playing_bench {

constexpr std::size_t steps = 16;
constexpr std::size_t steps_in_cache = 5;
constexpr int rounds = 3;
constexpr double target_part_of_speed = 0.7;

store::GenerateRequest series() {
    store::GenerateRequest request{
        "tornado",
        {core::Vec3(0.0), core::Vec3(1.0 / 249, 1.0 / 249, 1.0 / 99), {250, 250, 100}},
        {}};
    for (std::size_t i = 0; i < steps; ++i)
        request.times.push_back(0.2 * static_cast<double>(i));
    return request;
}

server::LoadedDataset open(const TemporaryStore& store, std::size_t budget) {
    auto opened = server::open_store(store.folder(), {budget, 1});
    if (!opened)
        throw std::runtime_error(opened.error().message);
    return std::move(*opened);
}

struct Played {
    double seconds;
    std::size_t vertices;
};

/// All of the series once, by the clock on the wall.
Played play(const core::Flow& flow) {
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Streak;
    p.to = (*flow.time_range())[1];
    p.separation = 0.004;
    p.accuracy = core::Accuracy::Fast; // the others retrace where all fits into memory
    const core::Rake rake{core::Rake::Kind::Line, {{0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}}, 16};
    const core::SteadyClock clock;
    const auto start = std::chrono::steady_clock::now();
    auto surface = core::MovingSurface::start(core::plan_surface(flow, rake, p).value(), {}, clock);
    while (surface && surface->time() != surface->end_time())
        if (const auto stepped = surface->step(surface->end_time(), {}); !stepped)
            throw std::runtime_error(stepped.error().message);
    if (!surface)
        throw std::runtime_error(surface.error().message);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    return {taken.count(), surface->state().mesh.vertices.used()};
}

void measure(benchmark::State& state) {
    const TemporaryStore store(series());
    const std::size_t step_bytes = store.reader()->bytes_per_step();
    const auto from_disk = open(store, steps_in_cache * step_bytes);
    const auto from_memory = open(store, steps * step_bytes);
    std::size_t vertices = 0;
    const auto turn = [&](const server::LoadedDataset& dataset) {
        return [&] {
            const Played played = play(*dataset.flow);
            vertices = played.vertices;
            return played.seconds;
        };
    };
    for (auto _ : state) {
        const auto taken = interleave({turn(from_disk), turn(from_memory)}, rounds);
        state.SetIterationTime(taken[0].median);
        state.counters["part_of_speed_from_memory"] = taken[1].median / taken[0].median;
        state.counters["target_part_of_speed_from_memory"] = target_part_of_speed;
        state.counters["megabytes_per_second"] =
            1e-6 * static_cast<double>(steps * step_bytes) / taken[0].median;
        state.counters["vertices_at_the_end"] = static_cast<double>(vertices);
        state.counters["spread"] = taken[0].spread;
    }
}

} // namespace playing_bench

void register_playing_benchmark() {
    using namespace playing_bench;
    benchmark::RegisterBenchmark("playing_from_disk", measure)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

} // namespace wakesurf::bench
