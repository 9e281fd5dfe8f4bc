#include "protocol/api/openrpc.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::protocol {

// generated/openrpc.json: embedded_openrpc.cmake makes their source.
extern const unsigned char openrpc_text[];
extern const unsigned long openrpc_size;

std::string openrpc_document(std::string_view version) {
    std::string text(openrpc_text, openrpc_text + openrpc_size);
    constexpr std::string_view unversioned = R"("version":"")";
    return text.replace(text.find(unversioned), unversioned.size(),
                        "\"version\":" + nlohmann::json(version).dump());
}

} // namespace wakesurf::protocol
