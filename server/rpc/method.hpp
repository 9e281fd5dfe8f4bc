// A method of the API as the dispatcher calls it: its description, which protocol/api has, and the code behind it. The code gets
// parameters that were checked against the description.
#pragma once

#include "protocol/api/base/checked_json.hpp"
#include "protocol/api/json_rpc.hpp"
#include "server/rpc/client.hpp"
#include "server/service/base/journal.hpp"
#include "server/service/base/visitor.hpp"
#include "server/service/compute/budgets.hpp"
#include "server/service/live/probe.hpp"
#include "server/service/metrics/metrics.hpp"
#include "server/service/session/data/datasets.hpp"
#include "server/service/session/people/grants.hpp"
#include "server/service/session/session_directory.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::server {

class FamilyJobs;
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
    std::function<Standing()> standing{}; ///< how the server stands; no one can say without
    Metrics* metrics = nullptr;           ///< no one counts without
    ImportWaiters* imports = nullptr;     ///< without, datasets are as they are
    std::string notice{};                 ///< a whole notification for each who joins; empty: none
    Budgets* budgets = nullptr;           ///< anybody may use as much as they like without
    FamilyJobs* families = nullptr;       ///< none are made without
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

/// Who may call a method, from where, and whether its answer waits for the disk.
struct MethodTraits {
    Role least = Role::Viewer; ///< the least role in the session that may
    bool websocket_only = false;
    bool edits = false;        ///< changes records that are kept
    bool whole_server = false; ///< not for share links, which are for one session
    bool copier = false; ///< in a copy also for who made it by a share link, whatever their role
};

struct Method {
    using Handler = std::function<void(const Call&, Reply)>;

    std::string name;
    MethodTraits traits;
    std::vector<std::string> parameters; ///< their names
    Handler handler;

    bool takes(std::string_view parameter) const;
};

/// The method of this name, as it is described. REQUIRES: there is one.
Method described(std::string_view name, Method::Handler handler);

/// The method whose parameters these are. `handle` is called only with parameters that keep what the description says; what does
/// not is answered with the first fault.
template <class Parameters>
Method method(void (*handle)(const Call& call, const Parameters& parameters, Reply reply)) {
    return described(Parameters::method, [handle](const Call& call, Reply reply) {
        protocol::CheckedJson in(call.parameters);
        Parameters parameters;
        read(in, parameters);
        if (const auto sound = in.verdict(); !sound)
            return reply.fault(sound.error());
        handle(call, parameters, std::move(reply));
    });
}

} // namespace wakesurf::server
