// `wakesurf info`: what a dataset is, without importing it.
#pragma once

#include <string>

namespace wakesurf::server {

struct InfoOptions {
    std::string dataset;
    bool json = false;
};

/// Exit status.
int run_info(const InfoOptions& options);

} // namespace wakesurf::server
