// From the text of a message to the text of its answer, by the method table.
#pragma once

#include "server/net/methods/method.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Loop thread only.
class Dispatcher {
  public:
    Dispatcher(std::vector<Method> methods, MethodContext context, protocol::RpcLimits limits);

    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    /// Takes one message: `identity` is whose call it is, `client` its WebSocket, if it has one. `answer` is
    /// called once, now or later, with the text to send back: empty when there is none (notifications).
    using Answer = std::function<void(std::string)>;
    void dispatch(std::string_view text, const Visitor& identity, Client* client, Answer answer);

    /// The OpenRPC document, of every method that is described.
    const std::string& document() const { return document_; }

  private:
    struct Caller {
        const Visitor& identity;
        Client* client;
    };

    void run(const protocol::RpcCall& call, const Caller& caller, bool batched, Answer answer);
    std::optional<protocol::RpcFault> too_fast(bool edits, const Caller& caller);
    const Method* find(std::string_view name) const;
    std::vector<std::string> names() const;

    std::vector<Method> methods_;
    MethodContext context_;
    protocol::RpcLimits limits_;
    std::string document_;
};

} // namespace wakesurf::server
