#include "server/app/other_programs.hpp"

#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/environment.hpp"
#include "server/base/shipped_files.hpp"

#include <CLI/CLI.hpp>
#include <stdlib.h>
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

void add_mcp_options(CLI::App& command, McpOptions& options) {
    auto* const datasets = command.add_option(
        "DATASET", options.datasets,
        "What to start a server for: files or folders of simulation results, stores, flow:NAME "
        "(default: $WAKESURF_URL, or else the bundled simulation)");
    command
        .add_option("--url", options.url,
                    "Address of a running server, with its token: $WAKESURF_URL keeps it from the "
                    "eyes of others on this machine, who can read command lines")
        ->excludes(datasets);
    command.add_option("--session", options.session,
                       "Session to work in (default: the one in the address, or else main)");
    command
        .add_option("--folder", options.folder,
                    "Files are written below this folder only (default: the current one)")
        ->check(CLI::ExistingDirectory);
}

int run_mcp(const McpOptions& options) {
    std::vector<std::string> words;
    for (const auto& [name, value] : {std::pair{"--url=", &options.url},
                                      {"--session=", &options.session},
                                      {"--folder=", &options.folder}})
        if (!value->empty())
            words.push_back(name + *value);
    words.emplace_back("--");
    words.insert(words.end(), options.datasets.begin(), options.datasets.end());
    return become_python("mcp", words);
}

namespace {

/// Files in the current folder must not replace modules, as they would for `python -m`.
constexpr const char* beginning = R"python(
import importlib, sys
sys.path[0] = sys.argv.pop(1)
try:
    import numpy
except ImportError:
    sys.exit("wakesurf: this needs numpy (Debian: python3-numpy; another Python that has it: $WAKESURF_PYTHON)")
sys.exit(importlib.import_module("wakesurf." + sys.argv.pop(1)).main())
)python";

/// Prefers the system's Python, which has the packages installed with this program, to the first one in PATH.
std::string python() {
    constexpr const char* of_the_system = "/usr/bin/python3";
    return from_environment("WAKESURF_PYTHON",
                            ::access(of_the_system, X_OK) == 0 ? of_the_system : "python3");
}

} // namespace

int become_python(const std::string& module, const std::vector<std::string>& arguments) {
    const auto client = python_client();
    if (!client)
        return report_failure(client.error());
    ::setenv("WAKESURF", this_program().c_str(), 0);
    std::vector<std::string> words{python(), "-c", beginning, client->string(), module};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execvp(pointers.front(), pointers.data());
    return report_failure(
        {core::Error::Code::Io,
         "cannot start " + words.front() + ": " + std::generic_category().message(errno),
         "it needs Python 3.9 or newer with numpy: Debian, python3-numpy; else name one in "
         "$WAKESURF_PYTHON"});
}

} // namespace wakesurf::server
