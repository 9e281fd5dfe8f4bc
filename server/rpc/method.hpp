// A method of the API: what it is called, what it takes, what it gives, and the code behind it. The table of these
// is the only place a method is named; dispatch, rpc.discover and /openrpc.json follow from it.
#pragma once

#include "protocol/api/json_rpc.hpp"
#include "server/base/journal.hpp"
#include "server/compute/budgets.hpp"
#include "server/metrics/metrics.hpp"
#include "server/rpc/client.hpp"
#include "server/session/data/datasets.hpp"
#include "server/session/live/probe.hpp"
#include "server/session/people/grants.hpp"
#include "server/session/people/visitor.hpp"
#include "server/session/session_directory.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

class ImportWaiters;

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
    Grants& grants;
    const core::Clock& clock;
    Loop& loop;
    Journal* journal = nullptr;           ///< answers to edits wait for it
    std::function<Standing()> standing{}; ///< how the server stands; nobody can say without
    Metrics* metrics = nullptr;           ///< nobody counts without
    ImportWaiters* imports = nullptr;     ///< without, datasets are as they are
    std::string notice{};                 ///< a whole notification for each who joins; empty: none
    Budgets* budgets = nullptr;           ///< anybody may use as much as they like without
};

struct Call {
    const MethodContext& context;
    const nlohmann::json& parameters; ///< an object, valid until the handler returns
    const Visitor& identity;          ///< valid until the handler returns
    Client* client;                   ///< nothing over HTTP
    bool batched;                     ///< the answer will wait for others
    std::stop_token stop{};           ///< the answer is not wanted any more, or its caller is gone
    std::stop_token cancelled{};      ///< by $/cancelRequest; fires before `stop`
};

/// One of a kind, of the caller's budget. Error: OverLimit.
core::Result<Budgets::Place> take(const Call& call, Use use);

struct Parameter {
    std::string name;
    std::string schema; ///< JSON Schema, as text
    bool required = false;
    std::string about;
};

/// Who may call a method, from where, and whether its answer waits for the disk.
struct MethodTraits {
    Role least = Role::Viewer; ///< the least role in the session that may
    bool websocket_only = false;
    bool edits = false; ///< changes records that are kept
    const char* result_schema = R"({"type":"object"})";
    bool whole_server = false; ///< not for share links, which are for one session
};

inline constexpr MethodTraits any_viewer{};
inline constexpr MethodTraits websocket_viewer{Role::Viewer, true, false};
inline constexpr MethodTraits any_editor{Role::Editor, false, true};
inline constexpr MethodTraits any_host{Role::Host, false, true};
inline constexpr MethodTraits server_editor{Role::Editor, false, true, R"({"type":"object"})",
                                            true};

struct Method {
    std::string name;
    std::string about;
    std::vector<Parameter> parameters;
    std::string result; ///< in words
    MethodTraits traits;
    std::function<void(const Call&, Reply)> handler;
};

} // namespace wakesurf::server
