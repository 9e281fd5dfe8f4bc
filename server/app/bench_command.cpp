#include "server/app/bench_command.hpp"

#include "server/app/failure.hpp"
#include "server/base/shipped_files.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace wakesurf::server {

void add_bench_options(CLI::App& command, BenchOptions& options) {
    command.add_option("NAME", options.names, "Only benchmarks whose names contain one of these");
    command.add_option("--data", options.data,
                       "Dataset to measure on; default: the bundled simulation");
    command.add_option("--seconds", options.seconds, "How long hostile tenants attack a server")
        ->check(CLI::Range(1, 86'400))
        ->capture_default_str();
    command.add_option("--json", options.json, "Also write the figures to this file");
}

int run_bench(const BenchOptions& options, std::filesystem::path program) {
    if (program.empty())
        program = this_program().parent_path() / "wakesurf-bench";
    std::vector<std::string> words{program.string()};
    if (!options.data.empty())
        words.push_back("--data=" + options.data);
    words.push_back("--seconds=" + std::to_string(options.seconds));
    if (!options.json.empty())
        words.push_back("--json=" + options.json);
    words.emplace_back("--"); // names may begin with a dash
    words.insert(words.end(), options.names.begin(), options.names.end());
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    const int why = errno;
    if (why == ENOENT)
        return report_failure({core::Error::Code::NotFound,
                               "the benchmark program is not at " + program.string(),
                               "./check builds it, and so does cmake with -DWAKESURF_TESTS=ON"});
    return report_failure(
        {core::Error::Code::Io,
         "cannot start " + program.string() + ": " + std::generic_category().message(why),
         "check that it is executable, or rebuild it with ./check"});
}

} // namespace wakesurf::server
