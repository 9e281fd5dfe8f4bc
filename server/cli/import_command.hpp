// `wakesurf import`: a source into a store of the user's choosing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace wakesurf::server {

struct ImportOptions {
    std::string dataset;
    std::string store;
    std::vector<std::string> fields;
    std::string times;     ///< T0:T1[:EVERY], or empty
    std::string precision; ///< single, half or empty
    std::size_t jobs = 0;  ///< 0: one a core
};

/// Exit status.
int run_import(const ImportOptions& options);

} // namespace wakesurf::server
