// `wakesurf import`: a source into a store of the user's choosing.
#pragma once

#include "store/command/source_options.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wakesurf::server {

struct ImportOptions {
    std::string dataset;
    std::string store;
    std::vector<std::string> fields;
    std::string times;     ///< T0:T1[:EVERY], several with commas, or empty
    std::string precision; ///< single, half or empty
    std::string layout = "auto";
    command::SourceOptions taken;
    std::size_t jobs = 0;     ///< 0: one a core
    std::uint64_t memory = 0; ///< bytes; 0: the importer's own bound
};

/// Imports, and returns the exit status.
int run_import(const ImportOptions& options);

} // namespace wakesurf::server
