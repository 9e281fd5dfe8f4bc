// The program `wakesurf-bench`: parses what `wakesurf bench` hands over and runs the benchmarks asked for.
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/base/shipped_files.hpp"
#include "tests/bench/benchmarks.hpp"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <exception>
#include <memory>

namespace wakesurf::bench {

namespace {

constexpr int failed = 1;
constexpr int wrong_usage = 2;

/// Google Benchmark takes its settings as a command line.
void initialize(const server::BenchOptions& options) {
    static std::vector<std::string> words; // it keeps a pointer to the first
    words = {"wakesurf bench"};
    if (!options.names.empty())
        words.push_back(fmt::format("--benchmark_filter={}", fmt::join(options.names, "|")));
    if (!options.json.empty()) {
        words.push_back("--benchmark_out=" + options.json);
        words.push_back("--benchmark_out_format=json");
    }
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
}

core::Result<std::shared_ptr<const server::LoadedDataset>> load(const std::string& dataset) {
    return server::resolve_dataset(dataset)
        .and_then([](const server::DatasetArgument& argument) {
            return server::open_dataset(argument, {server::default_store_root(), {}},
                                        [](const store::ImportProgress&) {});
        })
        .map([](server::LoadedDataset loaded) {
            return std::make_shared<const server::LoadedDataset>(std::move(loaded));
        });
}

int measure(const server::BenchOptions& options) {
    std::string dataset = options.data;
    if (dataset.empty()) {
        const auto bundled = server::bundled_simulation();
        if (!bundled)
            return server::report_failure(bundled.error());
        dataset = bundled->string();
    }
    const auto loaded = load(dataset);
    if (!loaded)
        return server::report_failure(loaded.error());
    register_advection_benchmarks();
    register_sampling_benchmarks();
    register_bricks_benchmarks();
    register_disk_benchmarks();
    register_http_benchmarks();
    register_cells_benchmarks();
    register_stream_surface_benchmarks();
    register_streak_frame_benchmarks();
    register_level_benchmark();
    register_slice_benchmark();
    register_interval_error_benchmarks();
    register_between_benchmarks();
    register_accuracy_benchmarks(*loaded);
    register_shape_benchmarks(*loaded);
    register_tessellation_benchmarks(*loaded);
    register_wire_benchmarks(*loaded);
    register_edit_benchmark(dataset);
    register_hostile_benchmark(dataset, options.seconds);
    register_flood_benchmark(dataset);
    register_decode_benchmark();
    initialize(options);
    const std::size_t ran = benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return ran > 0 ? 0 : failed; // Google Benchmark has said that no name matches
}

int run(int argc, char** argv) {
    CLI::App app{"Measures this machine.", "wakesurf bench"};
    server::BenchOptions options;
    server::add_bench_options(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // --help
        std::fprintf(stderr, "wakesurf-bench: %s (see --help)\n", error.what());
        return wrong_usage;
    }
    return measure(options);
}

} // namespace

} // namespace wakesurf::bench

int main(int argc, char** argv) {
    try {
        return wakesurf::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "wakesurf-bench: %s\n", error.what());
        return 1;
    }
}
