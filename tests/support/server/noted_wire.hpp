// The sending half of a client without a socket, which records what it is sent.
#pragma once

#include "server/net/methods/client.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::tests {

class NotedWire final : public server::Wire {
  public:
    void send(std::string message) override { sent.push_back(nlohmann::json::parse(message)); }

    bool may_follow(std::uint32_t) override { return true; }

    void follow(server::FrameCursor) override {}

    bool unfollow(std::uint32_t) override { return false; }

    bool acknowledge(std::uint32_t, std::optional<std::uint32_t>, std::uint32_t) override {
        return false;
    }

    void close(server::Goodbye goodbye, const std::string&) override { closed = goodbye; }

    std::vector<nlohmann::json> sent;
    std::optional<server::Goodbye> closed;
};

} // namespace wakesurf::tests
