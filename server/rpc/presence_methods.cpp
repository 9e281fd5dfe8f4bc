// presence.update.
#include "protocol/api/messages_presence.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/session_choice.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void update(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto update = protocol::read_presence(in, call.parameters, limits::presence_points);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (call.client->session() != *session)
        return reply.fault(core::Error{core::Error::Code::InvalidArgument,
                                       "presence is of the session joined", "join it first"});
    (*session)->participants().update(*call.client, update);
    reply.result(json::object());
}

} // namespace

std::vector<Method> presence_methods() {
    constexpr const char* point =
        R"({"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3})";
    return {
        {"presence.update",
         "Tells the others what one points at, looks at, drags and has selected. What is left "
         "out stays; null takes it away. Best sent as a notification.",
         {session_parameter(),
          {"pointer",
           R"({"type":["array","null"],"items":{"type":"number"},"minItems":3,"maxItems":3})",
           false, "a point of space"},
          {"camera",
           fmt::format(
               R"({{"type":["object","null"],"properties":{{"position":{0},"target":{0},"up":{0},"fov":{{"type":"number","minimum":1,"maximum":179}}}},"required":["position","target","up"],"additionalProperties":false}})",
               point),
           false, "where one looks from; fov in degrees, from top to bottom"},
          {"dragging",
           fmt::format(
               R"({{"type":["object","null"],"properties":{{"rake":{{"type":"string"}},"points":{{"type":"array","maxItems":{},"items":{}}}}},"required":["rake"],"additionalProperties":false}})",
               limits::presence_points, point),
           false, "a rake as it is on its way"},
          {"selected", R"({"type":["string","null"],"maxLength":64})", false, "id of a record"}},
         "{}",
         websocket_viewer,
         update}};
}

} // namespace wakesurf::server
