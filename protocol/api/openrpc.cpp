#include "protocol/api/openrpc.hpp"

#include "protocol/api/generated/openrpc_parts.hpp"

#include <nlohmann/json.hpp>

#include <span>

namespace wakesurf::protocol {

namespace {

void append(std::string& text, std::span<const std::string_view* const> parts) {
    for (const std::string_view* part : parts)
        text.append(part == parts.front() ? "" : ",\n").append(*part);
}

} // namespace

std::string openrpc_document(std::string_view version) {
    // Not `servers`: the specification has whole addresses there, and a server does not know all of its own.
    const nlohmann::json info{
        {"title", "wakesurf"},
        {"version", version},
        {"description",
         "Integral surfaces of flows, computed where the data are. Calls go to /rpc (POST) and /ws "
         "(WebSocket) of the server that gave this document; `data` of errors is a "
         "components/schemas/ErrorData."}};
    std::string text = R"({"openrpc":"1.3.2","info":)" + info.dump() +
                       R"(,"x-paths":{"http":"/rpc","websocket":"/ws"},"methods":[)";
    append(text, openrpc::methods);
    text += R"(],"components":{"schemas":{)";
    append(text, openrpc::schemas);
    text += R"(},"errors":{)";
    append(text, openrpc::errors);
    return text + "}}}";
}

} // namespace wakesurf::protocol
