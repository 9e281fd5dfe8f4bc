#include "server/net/methods/method.hpp"

#include "protocol/api/base/methods.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace wakesurf::server {

Reply::Reply(Reply&& other) noexcept : sink_(std::exchange(other.sink_, nullptr)) {}

Reply::~Reply() {
    if (sink_)
        fault({protocol::RpcCode::Internal, "the call was not answered", "try again", {}, {}});
}

void Reply::result(const nlohmann::json& value) {
    if (const Sink sink = std::exchange(sink_, nullptr))
        sink({.result = &value});
}

void Reply::made_result(const std::string& text) {
    if (const Sink sink = std::exchange(sink_, nullptr))
        sink({.made = &text});
}

void Reply::fault(const protocol::RpcFault& fault) {
    if (const Sink sink = std::exchange(sink_, nullptr))
        sink({.fault = &fault});
}

bool Method::takes(std::string_view parameter) const {
    return std::ranges::find(parameters, parameter) != parameters.end();
}

Method described(std::string_view name, Method::Handler handler) {
    const protocol::MethodDescription& about = *protocol::described_method(name);
    const MethodTraits traits{*role_named(about.least_role),
                              about.websocket_only,
                              about.edits,
                              about.whole_server,
                              about.shared,
                              about.copier};
    return {std::string(name),
            traits,
            {about.parameters.begin(), about.parameters.end()},
            std::move(handler)};
}

core::Result<Budgets::Permit> take(const Call& call, Use use) {
    Budgets* const budgets = call.context.budgets;
    return budgets == nullptr ? Budgets::Permit() : budgets->take(call.identity, use);
}

Reply held_until_settled(Reply reply, Journal& journal) {
    auto kept = std::make_shared<Reply>(std::move(reply));
    return Reply([kept, &journal](const Reply::Outcome& outcome) {
        if (outcome.fault != nullptr)
            return kept->fault(*outcome.fault);
        journal.settled(
            [kept, answer = *outcome.result](const core::Result<void>& written) mutable {
                if (answer.is_object()) {
                    answer["durable"] = written.has_value();
                    if (!written)
                        answer["hint"] = written.error().message + ": " + written.error().hint;
                }
                kept->result(answer);
            });
    });
}

std::vector<Method> method_table() {
    std::vector<Method> table;
    for (auto part :
         {server_methods, dataset_methods, family_methods, mean_methods, session_methods,
          session_keeping_methods, share_methods, presence_methods, rake_methods, surface_methods,
          subscription_methods, wait_methods, mark_methods, history_methods, time_methods})
        std::ranges::move(part(), std::back_inserter(table));
    return table;
}

} // namespace wakesurf::server
