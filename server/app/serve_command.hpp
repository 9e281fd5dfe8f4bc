// `wakesurf serve`: the server, until Ctrl-C.
#pragma once

#include "store/command/source_options.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct ServeOptions {
    std::vector<std::string> datasets;
    std::string listen = "127.0.0.1:8080";
    std::string store;
    command::SourceOptions taken; ///< of all datasets
    std::string state;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    unsigned threads = 0;
    /// The command that starts wakesurf-bricks; empty: it is not started.
    std::string bricks;
    std::uint64_t brick_memory = 0; ///< of each rank; 0: what it needs
    std::string token_file;
    bool new_token = false;
    std::string url_file;
    bool no_auth = false;
    std::vector<std::string> origins;
    std::vector<std::string> frame_origins;
    std::vector<std::string> trusted_proxies;
    std::string certificate;
    std::string key;
    std::string web;
    std::string log_level = "info";
    bool open = false;           ///< the page, in a browser
    bool port_by_chance = false; ///< if the one of `listen` is in use
};

void add_serve_options(CLI::App& command, ServeOptions& options);

/// Serves, and returns the exit status.
int run_serve(const ServeOptions& options);

} // namespace wakesurf::server
