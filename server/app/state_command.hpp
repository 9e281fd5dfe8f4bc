// `wakesurf state aside|backup|check|restore`: maintenance of the folder of `serve --state`, also while the
// server runs.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct StateCommandOptions {
    std::string folder;
    std::string file;
    bool damaged = false;
};

/// Adds the commands; the chosen one is put into `chosen`, to be run. Each returns the exit status: 0 done
/// (check: sound), 1 failed (check: damaged).
void add_state_commands(CLI::App& command,
                        StateCommandOptions& options,
                        std::function<int()>& chosen);

} // namespace wakesurf::server
