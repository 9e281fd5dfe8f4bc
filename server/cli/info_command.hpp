// `wakesurf info`: what a dataset is, without importing it.
#pragma once

#include "command/source_options.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::server {

struct InfoOptions {
    std::string dataset;
    bool json = false;
    command::SourceOptions taken;
    std::uint64_t memory = 0; ///< bytes that finding out may take; 0: the importer's own bound
};

/// Exit status.
int run_info(const InfoOptions& options);

} // namespace wakesurf::server
