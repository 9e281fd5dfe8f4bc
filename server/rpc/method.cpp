#include "server/rpc/method.hpp"

#include <nlohmann/json.hpp>

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

core::Result<Budgets::Place> take(const Call& call, Use use) {
    Budgets* const budgets = call.context.budgets;
    return budgets == nullptr ? Budgets::Place() : budgets->take(call.identity, use);
}

} // namespace wakesurf::server
