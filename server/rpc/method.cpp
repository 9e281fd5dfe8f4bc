#include "server/rpc/method.hpp"

#include "protocol/api/base/methods.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace wakesurf::server {

Reply::Reply(Reply&& other) noexcept : sink_(std::exchange(other.sink_, nullptr)) {}

Reply::~Reply() {
    if (sink_)
        fault({protocol::RpcCode::Internal, "the call was not answered", "try again", {}, {}});
}

void Reply::result(const nlohmann::json& value) {
    if (const Sink sink = std::exchange(sink_, nullptr))
        sink(&value, nullptr);
}

void Reply::fault(const protocol::RpcFault& fault) {
    if (const Sink sink = std::exchange(sink_, nullptr))
        sink(nullptr, &fault);
}

bool Method::takes(std::string_view parameter) const {
    return std::ranges::find(parameters, parameter) != parameters.end();
}

Method described(std::string_view name, Method::Handler handler) {
    const protocol::MethodDescription& about = *protocol::described_method(name);
    const MethodTraits traits{*role_named(about.least_role), about.websocket_only, about.edits,
                              about.whole_server, about.copier};
    return {std::string(name),
            traits,
            {about.parameters.begin(), about.parameters.end()},
            std::move(handler)};
}

core::Result<Budgets::Place> take(const Call& call, Use use) {
    Budgets* const budgets = call.context.budgets;
    return budgets == nullptr ? Budgets::Place() : budgets->take(call.identity, use);
}

} // namespace wakesurf::server
