#include "server/cli/failure.hpp"

#include "server/base/terminal_text.hpp"

#include <cstdio>

namespace wakesurf::server {

int report_failure(const core::Error& error) {
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    std::fprintf(stderr, "wakesurf: %s\n", terminal_text(error.message + hint).c_str());
    return 1;
}

} // namespace wakesurf::server
