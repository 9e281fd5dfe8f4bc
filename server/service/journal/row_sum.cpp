#include "server/service/journal/row_sum.hpp"

#include "server/service/base/secret.hpp"

#include <string>

namespace wakesurf::server {

std::uint64_t row_digest(const StoredKey& key, std::string_view json) {
    std::string text;
    text.reserve(key.session.size() + key.type.size() + key.id.size() + json.size() + 32);
    for (const std::string_view part : {std::string_view(key.session), std::string_view(key.type),
                                        std::string_view(key.id), json}) {
        text += std::to_string(part.size());
        text += ':';
        text += part;
    }
    const SecretDigest digest = secret_digest(text);
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < sizeof out; ++i)
        out = out << 8 | std::to_integer<std::uint64_t>(digest[i]);
    return out;
}

} // namespace wakesurf::server
