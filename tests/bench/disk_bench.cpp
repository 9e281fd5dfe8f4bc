// Time-steps in bricks on a disk that has nothing of them in its page cache: the first coarse surface, and playing a series that is longer
// than the cache beside the same reads alone.
#include "core/dataset/brick_cache.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/temporary_store.hpp"

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>

namespace wakesurf::bench {

namespace disk_bench {

using Clock = std::chrono::steady_clock;

constexpr double target_first_coarse_ms = 500;
constexpr double target_of_read_rate = 0.8;
constexpr double target_read_times_distinct = 1.3;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What the page cache has of a folder's files goes.
void forget_pages(const std::filesystem::path& folder) {
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder)) {
        const int file = ::open(each.path().c_str(), O_RDONLY);
        if (file < 0)
            continue;
        ::fsync(file); // pages that are not written yet would stay
        ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
        ::close(file);
    }
}

/// Notes which bricks of a store are read.
class NotedReads final : public core::TimeStepSource, public core::BrickSource {
  public:
    explicit NotedReads(std::shared_ptr<const store::StoreReader> store)
        : store_(std::move(store)) {}

    const core::Grid& grid() const override { return store_->grid(); }

    const core::SolidMask& mask() const override { return store_->mask(); }

    const std::vector<double>& times() const override { return store_->times(); }

    bool ready(std::size_t index) const override { return store_->ready(index); }

    std::size_t bytes_per_step() const override { return store_->bytes_per_step(); }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token stop) const override {
        return store_->load(index, stop);
    }

    const core::BrickSource* bricks() const override { return this; }

    const core::BrickLayout& layout() const override { return store_->bricks()->layout(); }

    bool gaps(std::size_t step) const override { return store_->bricks()->gaps(step); }

    void read(std::vector<core::BrickRead> reads, std::stop_token stop, Done done) const override {
        {
            const std::scoped_lock lock(mutex_);
            for (const core::BrickRead& each : reads)
                names_.push_back({each.step, each.brick});
        }
        store_->bricks()->read(std::move(reads), stop, std::move(done));
    }

    std::vector<core::BrickName> names() const {
        const std::scoped_lock lock(mutex_);
        return names_;
    }

  private:
    std::shared_ptr<const store::StoreReader> store_;
    mutable std::mutex mutex_;
    mutable std::vector<core::BrickName> names_;
};

core::Surface
surface_of(const core::Flow& flow, core::SurfaceKind kind, double to, std::uint64_t quads) {
    core::SurfaceParameters parameters;
    parameters.kind = kind;
    parameters.to = to;
    parameters.separation = 0.01;
    parameters.max_quads = quads;
    const core::Rake rake{core::Rake::Kind::Line, {{0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}}, 16};
    auto surface = core::build_surface(flow, rake, parameters);
    if (!surface)
        throw std::runtime_error(surface.error().message);
    return std::move(*surface);
}

std::shared_ptr<core::TimeStepCache> cache_of(std::shared_ptr<const core::TimeStepSource> source,
                                              std::size_t budget) {
    core::TimeStepCache::Options options;
    options.budget_bytes = budget;
    options.by_brick = true;
    return std::make_shared<core::TimeStepCache>(std::move(source), options);
}

store::GenerateRequest cube(std::uint32_t nodes, std::vector<double> times) {
    return {"tornado",
            {core::Vec3(0.0), core::Vec3(1.0 / (nodes - 1)), {nodes, nodes, nodes}},
            std::move(times),
            store::StepPlacement::Bricks};
}

void measure_cold(benchmark::State& state) {
    const TemporaryStore store(cube(1025, {0.0}));
    for (auto _ : state) {
        forget_pages(store.folder());
        const auto start = Clock::now();
        const auto cache = cache_of(store.reader(), std::size_t{1} << 30);
        const double opened = milliseconds_since(start);
        const auto flow = core::make_stored_flow(cache);
        const auto surface =
            surface_of(*flow, core::SurfaceKind::Stream, 0.5, 1000); // of PassBudgets' first pass
        const double took = milliseconds_since(start);
        state.SetIterationTime(1e-3 * took);
        state.counters["target_ms"] = target_first_coarse_ms;
        state.counters["open_ms"] = opened;
        state.counters["quads"] = static_cast<double>(surface.mesh.cells.size());
        state.counters["rounds"] = static_cast<double>(cache->bricks()->status().rounds);
        state.counters["bricks"] = static_cast<double>(cache->bricks()->status().reads);
    }
}

/// The same bricks again, in the order in which they were asked for, 64 at a time.
double milliseconds_to_read(const store::StoreReader& store,
                            const std::vector<core::BrickName>& names) {
    constexpr std::size_t at_a_time = 64;
    const std::size_t values = 3 * store.bricks()->layout().nodes_per_brick();
    std::vector<float> room(at_a_time * (values + 16)); // and wide loads of the last row
    const auto start = Clock::now();
    for (std::size_t begin = 0; begin < names.size(); begin += at_a_time) {
        const std::size_t count = std::min(at_a_time, names.size() - begin);
        std::vector<core::BrickRead> reads;
        for (std::size_t i = 0; i < count; ++i)
            reads.push_back({names[begin + i].step,
                             names[begin + i].brick,
                             {room.data() + i * (values + 16), values}});
        std::latch all(static_cast<std::ptrdiff_t>(count));
        store.bricks()->read(std::move(reads), {},
                             [&](std::size_t, const core::Result<void>&) { all.count_down(); });
        all.wait();
    }
    return milliseconds_since(start);
}

void measure_playing(benchmark::State& state) {
    std::vector<double> times;
    for (int i = 0; i < 9; ++i)
        times.push_back(0.25 * i);
    const TemporaryStore store(cube(257, times));
    for (auto _ : state) {
        const auto source = std::make_shared<NotedReads>(store.reader());
        const std::size_t budget = source->bytes_per_step() * times.size() / 3;
        const auto cache = cache_of(source, budget);
        const auto flow = core::make_stored_flow(cache);
        forget_pages(store.folder());
        const auto start = Clock::now();
        surface_of(*flow, core::SurfaceKind::Streak, times.back(), 1'000'000);
        const double cold = milliseconds_since(start);
        const std::vector<core::BrickName> names = source->names();
        const std::size_t distinct = std::set(names.begin(), names.end()).size();
        forget_pages(store.folder());
        const double reading = milliseconds_to_read(*store.reader(), names);
        const auto resident =
            core::make_stored_flow(cache_of(store.reader(), std::size_t{4} << 30));
        surface_of(*resident, core::SurfaceKind::Streak, times.back(), 1'000'000);
        const auto again = Clock::now();
        surface_of(*resident, core::SurfaceKind::Streak, times.back(), 1'000'000);
        const double computing = milliseconds_since(again);
        state.SetIterationTime(1e-3 * cold);
        state.counters["of_read_rate"] = reading / cold;
        state.counters["target_of_read_rate"] = target_of_read_rate;
        state.counters["reading_alone_ms"] = reading;
        state.counters["computing_alone_ms"] = computing;
        state.counters["megabytes_read"] =
            1e-6 * 12 * 33 * 33 * 33 * static_cast<double>(names.size());
        state.counters["read_times_distinct"] =
            static_cast<double>(names.size()) / static_cast<double>(distinct);
        state.counters["target_read_times_distinct"] = target_read_times_distinct;
    }
}

} // namespace disk_bench

void register_disk_benchmarks() {
    const auto run = [](const char* name, auto measure) {
        benchmark::RegisterBenchmark(name, measure)
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    run("bricks/disk/cold", disk_bench::measure_cold);
    run("bricks/disk/playing", disk_bench::measure_playing);
}

} // namespace wakesurf::bench
