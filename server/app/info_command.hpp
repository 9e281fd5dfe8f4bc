// `wakesurf info`: describes a dataset without importing it.
#pragma once

#include "store/command/source_options.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::server {

struct InfoOptions {
    std::string dataset;
    bool json = false;
    command::SourceOptions taken;
    std::uint64_t memory = 0; ///< in bytes, for describing it; 0: the importer's own bound
};

/// Prints the description, and returns the exit status.
int run_info(const InfoOptions& options);

} // namespace wakesurf::server
