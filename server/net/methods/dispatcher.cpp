#include "server/net/methods/dispatcher.hpp"

#include "protocol/api/base/nearest_name.hpp"
#include "protocol/api/openrpc.hpp"
#include "server/base/limits.hpp"
#include "server/base/log_text.hpp"
#include "server/net/methods/caller.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace wakesurf::server {

using nlohmann::json;
using protocol::RpcCall;
using protocol::RpcCode;
using protocol::RpcFault;

namespace {

/// Gathers the answers of a batch, until all are there.
struct Batch {
    std::vector<std::string> answers;
    std::size_t bytes = 0;
    std::size_t missing = 0;
    Dispatcher::Answer done;

    void add(const std::optional<protocol::RpcId>& id, std::string text) {
        if (id && bytes + text.size() > limits::outbox_message_bytes)
            text = protocol::rpc_error(*id, too_long());
        bytes += text.size();
        if (!text.empty())
            answers.push_back(std::move(text));
        if (--missing == 0)
            done(protocol::rpc_batch(answers));
    }

    static RpcFault too_long() {
        return {RpcCode::OverLimit,
                "the call was made, but its answer was left out: the answers of this batch exceed "
                "the length of one message",
                "put fewer calls into one batch",
                {},
                std::make_shared<const json>(json{{"limit", limits::outbox_message_bytes}})};
    }
};

/// Returns a hint with the name that the caller may have meant by `name`.
std::string
hint(const std::string& name, const std::vector<std::string>& names, std::string otherwise) {
    const std::string meant = protocol::nearest_name(name, names);
    return meant.empty() ? std::move(otherwise) : "did you mean `" + meant + "`?";
}

std::optional<RpcFault> unknown_parameter(const Method& method, const json& parameters) {
    if (!parameters.is_object())
        return std::nullopt;
    for (const auto& [name, value] : parameters.items()) {
        if (!method.takes(name))
            return RpcFault{RpcCode::InvalidParameters,
                            "`" + name.substr(0, 64) + "` is not a parameter of " + method.name,
                            hint(name, method.parameters, protocol::there_is(method.parameters)),
                            {},
                            {}};
    }
    return std::nullopt;
}

RpcFault too_many_calls() {
    return {RpcCode::OverLimit,
            "too many calls of this connection are not answered yet",
            "wait for answers, or end some calls with `$/cancelRequest`",
            {},
            std::make_shared<const json>(json{{"limit", limits::pending_calls}})};
}

const json no_parameters = json::object();

/// Bounds an id: what is longer is no id of ours, and may be a secret in the wrong place.
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

/// Writes a line of the log for each call, at level debug: which method, by whom, on what. Never what it
/// said.
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

} // namespace

Dispatcher::Dispatcher(std::vector<Method> methods,
                       MethodContext context,
                       protocol::RpcLimits limits)
    : methods_(std::move(methods)), context_(std::move(context)), limits_(limits),
      document_(protocol::openrpc_document(WAKESURF_VERSION)) {
    methods_.push_back(described("rpc.discover", [this](const Call&, Reply reply) {
        reply.result(json::parse(document_));
    }));
}

const Method* Dispatcher::find(std::string_view name) const {
    const auto found = std::find_if(methods_.begin(), methods_.end(),
                                    [&](const Method& each) { return each.name == name; });
    return found == methods_.end() ? nullptr : &*found;
}

std::vector<std::string> Dispatcher::names() const {
    std::vector<std::string> out;
    for (const Method& each : methods_)
        out.push_back(each.name);
    return out;
}

void Dispatcher::dispatch(std::string_view text,
                          const Visitor& identity,
                          Client* client,
                          Answer answer) {
    const Caller caller{identity, client};
    const protocol::RpcMessage message = protocol::parse_rpc(text, limits_);
    if (!message.batch)
        return run(message.calls.front(), caller, false, std::move(answer));
    auto batch = std::make_shared<Batch>();
    batch->missing = message.calls.size();
    batch->done = std::move(answer);
    for (const RpcCall& call : message.calls)
        run(call, caller, true,
            [batch, id = call.id](std::string each) { batch->add(id, std::move(each)); });
}

std::optional<RpcFault> Dispatcher::too_fast(bool edits, const Caller& caller) {
    const auto wait =
        context_.budgets != nullptr ? context_.budgets->call(caller.identity, edits) : std::nullopt;
    if (!wait)
        return std::nullopt;
    return RpcFault{RpcCode::OverLimit,
                    "too many calls: the rate limit is exceeded",
                    "wait for data.retryAfterMs milliseconds",
                    {},
                    std::make_shared<const json>(
                        json{{"retryAfterMs", wait->retry_after.count()}, {"limit", wait->limit}})};
}

void Dispatcher::run(const RpcCall& call, const Caller& caller, bool batched, Answer answer) {
    std::stop_token stop;
    std::stop_token cancelled;
    if (caller.client != nullptr && call.id) {
        const auto pending = caller.client->calls().open(*call.id, answer);
        if (!pending)
            return answer(protocol::rpc_error(*call.id, too_many_calls()));
        stop = pending->stop();
        cancelled = pending->cancelled();
        answer = [pending](std::string text) { pending->answer(std::move(text)); };
    }
    Reply reply([id = call.id, metrics = context_.metrics, budgets = context_.budgets,
                 who = caller.identity, answer = std::move(answer)](const Reply::Outcome& outcome) {
        const RpcFault* const fault = outcome.fault;
        if (fault != nullptr && metrics != nullptr)
            metrics->error(static_cast<int>(fault->code));
        if (!id)
            answer({});
        else if (fault == nullptr) {
            std::string text = outcome.made != nullptr ? protocol::rpc_result_of(*id, *outcome.made)
                                                       : protocol::rpc_result(*id, *outcome.result);
            if (budgets != nullptr)
                budgets->answered(who, text.size());
            answer(std::move(text));
        } else
            answer(protocol::rpc_error(*id, *fault));
    });
    const Method* method = call.refused ? nullptr : find(call.method);
    if (const auto fault = too_fast(method != nullptr && method->traits.edits, caller))
        return reply.fault(*fault);
    if (call.refused)
        return reply.fault(*call.refused);
    if (method == nullptr)
        return reply.fault({RpcCode::MethodNotFound,
                            "there is no method `" + call.method.substr(0, 64) + "`",
                            hint(call.method, names(), "`rpc.discover` lists the methods"),
                            {},
                            {}});
    if (method->traits.websocket_only && caller.client == nullptr)
        return reply.fault({RpcCode::InvalidRequest,
                            method->name + " needs a WebSocket",
                            "connect to /ws with the subprotocol wakesurf.v1",
                            {},
                            {}});
    const json& given = *call.parameters;
    const json& parameters = given.is_array() && given.empty() ? no_parameters : given;
    const Call made{context_, parameters, caller.identity, caller.client, batched, stop, cancelled};
    if (const auto fault = refused(*method, made))
        return reply.fault(*fault);
    if (const auto unknown = unknown_parameter(*method, parameters))
        return reply.fault(*unknown);
    log_call(*method, made);
    try {
        const bool held = method->traits.edits && context_.journal != nullptr;
        method->handler(made, held ? held_until_settled(std::move(reply), *context_.journal)
                                   : std::move(reply));
    } catch (const std::exception&
                 error) { // the reply, moved into the handler, answers as it is destroyed
        spdlog::error("event=call_failed method={} reason={}", method->name,
                      log_value(without_paths(error.what())));
    }
}

} // namespace wakesurf::server
