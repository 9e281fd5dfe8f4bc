// Bricks from the memory of two ranks beside the same from files, and how soon a surface is there when a rank was killed.
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "server/service/bricks/ranked_store.hpp"
#include "store/open_store.hpp"
#include "store/store_generation.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/interleaved.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/ranks_of_job.hpp"
#include "tests/support/read_bricks.hpp"

#include <benchmark/benchmark.h>
#include <signal.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

namespace ranks_bench {

using server::RankBricks;
using server::RankedStore;

constexpr int repetitions = 9;
constexpr int ranks = 2;
constexpr double target_seconds_to_next_surface = 2.0;
constexpr std::chrono::minutes at_most{5};

/// By the clock: what is measured is waited for, by a thread that computes next to nothing.
template <class Work>
double wall_seconds(const Work& work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// A store of 129^3 x 5 in bricks, and what is asked of it: all 320 bricks, 64 in a round.
struct Store {
    Store() {
        std::string name =
            (std::filesystem::temp_directory_path() / "wakesurf-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("cannot make a folder");
        folder = name;
        store::GenerateRequest request;
        request.flow = "tornado";
        request.grid = {core::Vec3(0.0), core::Vec3(1.0 / 128), {129, 129, 129}};
        request.times = {0.0, 1.0, 2.0, 3.0, 4.0};
        request.placement = store::StepPlacement::Bricks;
        if (auto made = store::generate_store(request, folder / "s", [](const auto&) {}, {}); !made)
            throw std::runtime_error(made.error().message);
        reader = store::open_store(folder / "s").value().reader;
    }

    ~Store() { std::filesystem::remove_all(folder); }

    RankBricks::Options job(const std::vector<std::string>& more) const {
        RankBricks::Options options;
        options.words = tests::mpirun(ranks);
        options.words.insert(options.words.end(), more.begin(), more.end());
        options.program = tests::bricks_program();
        options.store = folder / "s";
        return options;
    }

    double read_all(const core::BrickSource& source) const {
        const std::size_t bricks = source.layout().count();
        const std::size_t values = 3 * source.layout().nodes_per_brick();
        std::vector<float> room(bricks * values);
        return wall_seconds([&] {
            for (std::size_t step = 0; step < reader->times().size(); ++step) {
                std::vector<core::BrickRead> reads;
                for (std::size_t i = 0; i < bricks; ++i)
                    reads.push_back({step, i, std::span(room).subspan(i * values, values)});
                for (const auto& outcome : tests::outcomes_of(source, reads))
                    if (!outcome)
                        throw std::runtime_error(outcome.error().message);
            }
        });
    }

    std::filesystem::path folder;
    std::shared_ptr<const store::StoreReader> reader;
};

double streak_seconds(const std::shared_ptr<RankedStore>& source) {
    core::TimeStepCache::Options options;
    options.by_brick = true;
    options.budget_bytes = std::size_t{32} << 20;
    const auto flow =
        core::make_stored_flow(std::make_shared<core::TimeStepCache>(source, options));
    core::SurfaceParameters parameters;
    parameters.kind = core::SurfaceKind::Streak;
    parameters.to = 4.0;
    parameters.separation = 0.08;
    const core::Rake rake{core::Rake::Kind::Line, {{0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}}, 16};
    return wall_seconds([&] {
        if (const auto made = core::build_surface(*flow, rake, parameters); !made)
            throw std::runtime_error(made.error().message);
    });
}

void measure(benchmark::State& state, const std::vector<std::string>& more) {
    if (!std::filesystem::exists(tests::bricks_program()))
        return state.SkipWithError("wakesurf-bricks is not built: configure with WAKESURF_MPI");
    spdlog::set_level(spdlog::level::err); // a killed rank is told of
    const Store store;
    const auto source = std::make_shared<RankedStore>(store.reader, store.job(more));
    source->ranks().begin();
    if (!source->ranks().wait_for_job(1, at_most))
        return state.SkipWithError("the job does not come");
    const double all =
        static_cast<double>(store.reader->times().size() * source->bricks()->layout().count());
    while (source->ranks().status().by_ranks < static_cast<std::uint64_t>(2 * all))
        store.read_all(*source->bricks()); // until they hold it
    for (auto _ : state) {
        const auto taken = interleave({[&] { return store.read_all(*source->bricks()); },
                                       [&] { return store.read_all(*store.reader->bricks()); }},
                                      repetitions);
        state.SetIterationTime(taken[0].median);
        state.counters["times_as_long_as_files"] = taken[0].median / taken[1].median;
        state.counters["rounds"] = static_cast<double>(store.reader->times().size());
        state.counters["megabytes"] =
            1e-6 * all * 12.0 * static_cast<double>(source->bricks()->layout().nodes_per_brick());
        const double usual = streak_seconds(source);
        const auto victims = tests::ranks_of(store.folder);
        const double next = wall_seconds([&] {
            ::kill(victims.back(), SIGKILL);
            streak_seconds(source);
        });
        state.counters["seconds_to_a_surface"] = usual;
        state.counters["seconds_to_a_surface_after_a_kill"] = next;
        state.counters["target_seconds_after_a_kill"] = target_seconds_to_next_surface;
    }
}

} // namespace ranks_bench

void register_ranks_benchmarks() {
    using namespace ranks_bench;
    const auto run = [](const std::string& name, const std::vector<std::string>& more) {
        benchmark::RegisterBenchmark(("bricks/ranks/" + name).c_str(),
                                     [more](benchmark::State& state) { measure(state, more); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    run("shared_memory", {});
    run("tcp", {"--mca", "pml", "ob1", "--mca", "btl", "tcp,self", "--mca", "osc", "^sm"});
}

} // namespace wakesurf::bench
