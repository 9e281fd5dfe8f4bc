#include "server/bench/bench_command.hpp"

#include "server/bench/benchmarks.hpp"
#include "server/catalogue/shipped_files.hpp"
#include "server/cli/failure.hpp"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <memory>

namespace wakesurf::server {

namespace {

/// Google Benchmark takes its settings as a command line.
void initialize(const BenchOptions& options) {
    std::vector<std::string> words{"wakesurf bench"};
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

core::Result<std::shared_ptr<const LoadedDataset>> load(const std::string& dataset) {
    return resolve_dataset(dataset)
        .and_then([](const DatasetArgument& argument) {
            return open_dataset(argument, {default_store_root(), {}}, [](const ImportProgress&) {});
        })
        .map([](LoadedDataset loaded) {
            return std::make_shared<const LoadedDataset>(std::move(loaded));
        });
}

} // namespace

void add_bench_options(CLI::App& command, BenchOptions& options) {
    command.add_option("NAME", options.names, "Only benchmarks whose names contain one of these");
    command.add_option("--data", options.data,
                       "Dataset to measure on; default: the bundled simulation");
    command.add_option("--json", options.json, "Also write the figures to this file");
}

int run_bench(const BenchOptions& options) {
    std::string dataset = options.data;
    if (dataset.empty()) {
        const auto bundled = bundled_simulation();
        if (!bundled)
            return report_failure(bundled.error());
        dataset = bundled->string();
    }
    const auto loaded = load(dataset);
    if (!loaded)
        return report_failure(loaded.error());
    register_surface_benchmarks(*loaded);
    register_edit_benchmark(dataset);
    register_drag_benchmark(dataset);
    initialize(options);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

} // namespace wakesurf::server
