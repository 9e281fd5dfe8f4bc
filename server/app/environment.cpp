#include "server/app/environment.hpp"

#include <cstdlib>
#include <utility>

namespace wakesurf::server {

std::string from_environment(const char* variable, std::string otherwise) {
    const char* value = std::getenv(variable);
    return value == nullptr || *value == '\0' ? std::move(otherwise) : std::string(value);
}

bool in_container() {
    return !from_environment("container").empty();
}

} // namespace wakesurf::server
