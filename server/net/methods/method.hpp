// A method of the API as the dispatcher calls it: its description, which protocol/api has, and the code
// behind it. The code gets parameters that were checked against the description.
#pragma once

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/json_rpc.hpp"
#include "server/base/identity.hpp"
#include "server/base/journal.hpp"
#include "server/base/metrics.hpp"
#include "server/data/datasets.hpp"
#include "server/live/compute/budgets.hpp"
#include "server/live/prober.hpp"
#include "server/net/methods/client.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/session_directory.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::server {

class DatasetAnswers;
class KeptFieldJobs;
class ImportWaiters;

/// Is the one answer to a call. Move-only; one that goes unanswered answers with an internal error.
class Reply {
  public:
    /// One of the three.
    struct Outcome {
        const nlohmann::json* result = nullptr;
        const std::string* made = nullptr; ///< a result as JSON text
        const protocol::RpcFault* fault = nullptr;
    };

    using Sink = std::function<void(const Outcome&)>;

    explicit Reply(Sink sink) : sink_(std::move(sink)) {}

    ~Reply();
    Reply(Reply&& other) noexcept;
    Reply& operator=(Reply&&) = delete;
    Reply(const Reply&) = delete;

    void result(const nlohmann::json& value);
    /// Answers with JSON text that was made before, of a method that edits nothing.
    void made_result(const std::string& text);
    void fault(const protocol::RpcFault& fault);

    void fault(const core::Error& error) { this->fault(protocol::fault_of(error)); }

  private:
    Sink sink_;
};

std::shared_ptr<DatasetAnswers> new_dataset_answers();

/// Holds what the methods act on.
struct MethodContext {
    SessionDirectory& sessions;
    const Datasets& datasets;
    std::function<nlohmann::json()> list_datasets; ///< entries of dataset.list
    Prober& prober;
    Grants& grants;
    const core::Clock& clock;
    Loop& loop;
    Journal* journal = nullptr;             ///< answers to edits wait for it
    std::function<ServerStatus()> status{}; ///< how the server stands; may be empty
    Metrics* metrics = nullptr;             ///< null: calls are not counted
    ImportWaiters* imports = nullptr;       ///< null: datasets stay as they are
    std::string notice{};       ///< a notification for each client that joins; empty: none
    Budgets* budgets = nullptr; ///< null: nothing is limited
    KeptFieldJobs* kept_fields = nullptr; ///< null: none are made
    /// Made once for all calls.
    std::shared_ptr<DatasetAnswers> answers = new_dataset_answers();
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

/// Takes one of a kind, of the caller's budget. Error: OverLimit.
core::Result<Budgets::Permit> take(const Call& call, Use use);

/// Says who may call a method, from where, and whether its answer waits for the disk.
struct MethodTraits {
    Role least = Role::Viewer; ///< the least role in the session that may
    bool websocket_only = false;
    bool edits = false;        ///< changes records that are kept
    bool whole_server = false; ///< not for share links, which are for one session
    bool shared = false; ///< about what all sessions share: by the link's role, also in a copy
    bool copier = false; ///< in a copy also for its maker by a share link, whatever the role
};

struct Method {
    using Handler = std::function<void(const Call&, Reply)>;

    std::string name;
    MethodTraits traits;
    std::vector<std::string> parameters; ///< their names
    Handler handler;

    bool takes(std::string_view parameter) const;
};

/// Returns the method of this name, as it is described. REQUIRES: there is one.
Method described(std::string_view name, Method::Handler handler);

/// Returns the method whose parameters these are. `handle` is called only with parameters that keep what the
/// description says; what does not is answered with the first fault.
template <class Parameters>
Method method(void (*handle)(const Call& call, const Parameters& parameters, Reply reply)) {
    return described(Parameters::method, [handle](const Call& call, Reply reply) {
        const auto parameters = protocol::parse_call<Parameters>(call.parameters);
        if (!parameters)
            return reply.fault(parameters.error());
        handle(call, *parameters, std::move(reply));
    });
}

/// Returns a reply that gives its result to `reply` once the journal has settled, with the member `durable`:
/// what has been answered has been kept. Where `durable` is false, the edit counts all the same, and `hint`
/// says why it is not kept. Faults go through at once. REQUIRES: the journal outlives it.
Reply held_until_settled(Reply reply, Journal& journal);

// The methods of each noun, or of a part of it.
std::vector<Method> server_methods();
std::vector<Method> dataset_methods();
std::vector<Method> family_methods();
std::vector<Method> mean_methods();
std::vector<Method> session_methods();
std::vector<Method> session_keeping_methods();
std::vector<Method> share_methods();
std::vector<Method> presence_methods();
std::vector<Method> rake_methods();
std::vector<Method> surface_methods();
std::vector<Method> subscription_methods();
std::vector<Method> history_methods();
std::vector<Method> wait_methods();
std::vector<Method> time_methods();
std::vector<Method> mark_methods();

/// Returns all of them.
std::vector<Method> method_table();

} // namespace wakesurf::server
