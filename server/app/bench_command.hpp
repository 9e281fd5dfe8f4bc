// `wakesurf bench`: the product's own figures on this machine. The benchmarks are a program of their own,
// `wakesurf-bench` (tests/bench), because they link Google Benchmark and VTK; this command only starts it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct BenchOptions {
    std::vector<std::string> names; ///< benchmarks whose names contain one of these; empty: all
    std::string data;               ///< a dataset; empty: the bundled simulation
    int seconds = 60;               ///< of an attack
    std::string json;               ///< file for Google Benchmark's JSON; empty: none
};

/// Declares the options, the same in both programs.
void add_bench_options(CLI::App& command, BenchOptions& options);

/// Replaces this process by wakesurf-bench, whose exit status is then the command's. Returns 1 if it cannot
/// be started.
/// @param program  empty: wakesurf-bench beside our own executable
int run_bench(const BenchOptions& options, std::filesystem::path program = {});

} // namespace wakesurf::server
