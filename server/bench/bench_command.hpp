// `wakesurf bench`: the product's own figures on this machine, on the bundled simulation or a dataset of the user's.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct BenchOptions {
    std::vector<std::string> names; ///< benchmarks whose names contain one of these; empty: all
    std::string data;               ///< a dataset; empty: the bundled simulation
    std::string json;               ///< file for Google Benchmark's JSON; empty: none
};

void add_bench_options(CLI::App& command, BenchOptions& options);

/// Returns the exit status. A benchmark that needs what this machine lacks (a browser) says so and is skipped.
int run_bench(const BenchOptions& options);

} // namespace wakesurf::server
