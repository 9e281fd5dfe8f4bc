// `wakesurf generate`: a built-in flow, sampled into a store.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace wakesurf::server {

/// Holds the options as given; run_generate checks the texts.
struct GenerateOptions {
    std::string flow;
    std::string folder;
    std::string grid = "64,64,64";
    std::string times; ///< empty: the flow's own
    std::string parameters;
    std::string layout = "auto";
};

void add_generate_options(CLI::App& command, GenerateOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_generate(const GenerateOptions& options);

} // namespace wakesurf::server
