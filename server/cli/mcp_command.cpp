#include "server/cli/mcp_command.hpp"

#include "server/catalogue/shipped_files.hpp"
#include "server/cli/environment.hpp"
#include "server/cli/failure.hpp"

#include <CLI/CLI.hpp>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace wakesurf::server {

namespace {

/// What lies in the folder that it is started in must not be taken for a part of it, as `python -m` would.
constexpr const char* beginning = R"python(
import sys
sys.path[0] = sys.argv.pop(1)
try:
    import numpy
except ImportError:
    sys.exit("wakesurf: this needs numpy (Debian: python3-numpy; another Python that has it: $WAKESURF_PYTHON)")
from wakesurf.mcp import main
sys.exit(main())
)python";

/// The system's own, which has the packages that were installed with this program, before one that happens to come first in PATH.
std::string python() {
    constexpr const char* of_the_system = "/usr/bin/python3";
    return from_environment("WAKESURF_PYTHON",
                            ::access(of_the_system, X_OK) == 0 ? of_the_system : "python3");
}

} // namespace

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
    const auto client = python_client();
    if (!client)
        return report_failure(client.error());
    ::setenv("WAKESURF", this_program().c_str(), 0);
    std::vector<std::string> words{python(), "-c", beginning, client->string()};
    for (const auto& [name, value] : {std::pair{"--url=", &options.url},
                                      {"--session=", &options.session},
                                      {"--folder=", &options.folder}})
        if (!value->empty())
            words.push_back(name + *value);
    words.emplace_back("--");
    words.insert(words.end(), options.datasets.begin(), options.datasets.end());
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execvp(arguments.front(), arguments.data());
    return report_failure(
        {core::Error::Code::Io,
         "cannot start " + words.front() + ": " + std::generic_category().message(errno),
         "it needs Python 3.9 or newer with numpy: Debian, python3-numpy; else "
         "name one in $WAKESURF_PYTHON"});
}

} // namespace wakesurf::server
