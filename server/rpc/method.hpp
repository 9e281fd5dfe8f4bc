// A method of the API: what it is called, what it takes, what it gives, and the code behind it. The table of these
// is the only place a method is named; dispatch, rpc.discover and /openrpc.json follow from it.
#pragma once

#include "protocol/json_rpc.hpp"
#include "server/rpc/client.hpp"
#include "server/session/datasets.hpp"
#include "server/session/probe.hpp"
#include "server/session/session_directory.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

/// The one answer to a call. Move-only; one that goes unanswered answers with an internal error.
class Reply {
  public:
    using Sink = std::function<void(const nlohmann::json* result, const protocol::RpcFault* fault)>;

    explicit Reply(Sink sink) : sink_(std::move(sink)) {}

    ~Reply();
    Reply(Reply&& other) noexcept;
    Reply& operator=(Reply&&) = delete;
    Reply(const Reply&) = delete;

    void result(const nlohmann::json& value);
    void fault(const protocol::RpcFault& fault);

    void fault(const core::Error& error) { this->fault(protocol::fault_of(error)); }

  private:
    Sink sink_;
};

/// What the methods act on.
struct MethodContext {
    SessionDirectory& sessions;
    const Datasets& datasets;
    std::function<nlohmann::json()> list_datasets; ///< entries of dataset.list
    Prober& prober;
};

struct Call {
    const MethodContext& context;
    const nlohmann::json& parameters; ///< an object, valid until the handler returns
    Client* client;                   ///< nothing over HTTP
    bool batched;                     ///< the answer will wait for others
};

struct Parameter {
    std::string name;
    std::string schema; ///< JSON Schema, as text
    bool required = false;
    std::string about;
};

struct Method {
    std::string name;
    std::string about;
    std::vector<Parameter> parameters;
    std::string result; ///< in words
    bool websocket_only = false;
    std::function<void(const Call&, Reply)> handler;
};

} // namespace wakesurf::server
