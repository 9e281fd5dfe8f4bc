#include "server/rpc/call_log.hpp"

#include "server/service/base/log_text.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <string>

namespace wakesurf::server {

namespace {

/// What is longer is no id of ours, and may be a secret in the wrong place.
constexpr std::size_t longest_id = 32;

/// ` name=id`, or nothing.
std::string id_field(const char* name, const std::string& id) {
    if (id.empty() || id.size() > longest_id)
        return {};
    return std::string(" ") + name + "=" + log_value(id);
}

std::string parameter(const Call& call, const char* name) {
    const auto found = call.parameters.find(name);
    return found != call.parameters.end() && found->is_string() ? found->get<std::string>() : "";
}

} // namespace

void log_call(const Method& method, const Call& call) {
    if (!spdlog::should_log(spdlog::level::debug))
        return;
    std::string session = parameter(call, "session");
    if (session.empty() && call.client != nullptr && call.client->session())
        session = call.client->session()->id();
    spdlog::debug("event=call method={}{}{}{}{}{}", method.name, id_field("session", session),
                  id_field("surface", parameter(call, "surface")),
                  id_field("rake", parameter(call, "rake")),
                  id_field("participant", call.client ? call.client->participant() : ""),
                  id_field("grant", call.identity.grant));
}

} // namespace wakesurf::server
