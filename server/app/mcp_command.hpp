// `wakesurf mcp`: the tools for programs that are driven by a language model, over standard input and output.
// They are part of the client for Python (python/wakesurf/mcp), which replaces this process.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct McpOptions {
    std::vector<std::string> datasets;
    std::string url;
    std::string session;
    std::string folder;
};

void add_mcp_options(CLI::App& command, McpOptions& options);

/// Returns only if they cannot be started, with the exit status.
int run_mcp(const McpOptions& options);

} // namespace wakesurf::server
