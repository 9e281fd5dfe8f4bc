#include "server/app/failure.hpp"

#include "server/app/own_words.hpp"
#include "server/app/tell.hpp"

namespace wakesurf::server {

int report_failure(const core::Error& told) {
    const core::Error error = with_commands(told);
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    tell(stderr, "wakesurf: {}\n", core::printable_line(error.message + hint));
    return 1;
}

} // namespace wakesurf::server
