#include "server/sessions/people/free_name.hpp"

#include "core/base/plain_text.hpp"

namespace wakesurf::server {

std::string free_name(const std::string& name,
                      std::size_t longest,
                      const std::function<bool(const std::string&)>& taken) {
    std::string candidate = name;
    for (std::size_t number = 2; taken(candidate); ++number) {
        const std::string suffix = " " + std::to_string(number);
        candidate = core::display_name(name, longest - suffix.size()) + suffix;
    }
    return candidate;
}

} // namespace wakesurf::server
