// A server with a host in its session, who makes share links.
#pragma once

#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace wakesurf::tests {

inline Headers with_key(const std::string& key) {
    return {{"Authorization", "Bearer " + key}};
}

class SharedSession : public testing::Test {
  protected:
    using json = nlohmann::json;

    json share(const std::string& role, json more = json::object()) {
        more["role"] = role;
        return host.result("session.share", more);
    }

    /// Returns the code the server closes with; what it says before is dropped.
    static unsigned close_code(WebSocketClient& client) {
        for (;;) {
            const auto message = client.receive();
            if (message.opcode == 8 || message.opcode == 0)
                return message.close_code();
        }
    }

    static json rake(double x) {
        return {{"kind", "line"}, {"points", {{x, 0, 0}, {x + 1, 0, 0}}}, {"seeds", 4}};
    }

    ServerProcess server;
    WebSocketClient host{server};
};

} // namespace wakesurf::tests
