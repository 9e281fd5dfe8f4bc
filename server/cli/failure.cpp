#include "server/cli/failure.hpp"

#include <cstdio>

namespace wakesurf::server {

int report_failure(const core::Error& error) {
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    std::fprintf(stderr, "wakesurf: %s%s\n", error.message.c_str(), hint.c_str());
    return 1;
}

} // namespace wakesurf::server
