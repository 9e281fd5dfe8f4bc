#include "server/app/mcp_command.hpp"

#include "server/app/python_program.hpp"

#include <CLI/CLI.hpp>

#include <utility>

namespace wakesurf::server {

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

} // namespace wakesurf::server
