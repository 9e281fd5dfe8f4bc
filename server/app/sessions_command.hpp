// `wakesurf sessions`: lists and changes sessions of a running server, or of a state folder that no server
// uses.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct SessionsOptions {
    std::string url;   ///< empty: $WAKESURF_URL, else $WAKESURF_STATE
    std::string state; ///< folder
    std::string authority;
    std::string action;
    std::string session;
    std::string name;
    std::string file;
    bool trash = false;
    bool forever = false;
    bool json = false;
    bool overwrite = false;
};

void add_sessions_options(CLI::App& command, SessionsOptions& options);

/// Runs the command, and returns the exit status.
int run_sessions(const SessionsOptions& options);

} // namespace wakesurf::server
