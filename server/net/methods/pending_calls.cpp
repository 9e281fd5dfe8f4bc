#include "server/net/methods/pending_calls.hpp"

#include "server/base/limits.hpp"

#include <utility>
#include <vector>

namespace wakesurf::server {

void PendingCall::answer(std::string text) {
    if (const Answer send = std::exchange(answer_, nullptr))
        send(std::move(text));
}

void PendingCall::cancel() {
    if (answered())
        return;
    answer(protocol::rpc_error(id_, {protocol::RpcCode::Cancelled,
                                     "the call was cancelled by `$/cancelRequest`",
                                     "call again for an answer",
                                     {},
                                     {}}));
    cancelled_.request_stop();
    stop_.request_stop();
}

void PendingCall::abandon() {
    answer_ = nullptr;
    stop_.request_stop();
}

void PendingCalls::abandon() {
    for (const auto& [id, call] : std::exchange(calls_, {}))
        call->abandon();
}

std::shared_ptr<PendingCall> PendingCalls::open(const protocol::RpcId& id,
                                                PendingCall::Answer answer) {
    forget_answered();
    if (calls_.size() >= limits::pending_calls)
        return nullptr;
    auto call = std::make_shared<PendingCall>(id, std::move(answer));
    calls_.emplace(id, call);
    return call;
}

void PendingCalls::cancel(const protocol::RpcId& id) {
    std::vector<std::shared_ptr<PendingCall>> named;
    const auto [begin, end] = calls_.equal_range(id);
    for (auto each = begin; each != end; ++each)
        named.push_back(each->second);
    calls_.erase(begin, end);
    for (const auto& call : named)
        call->cancel();
}

std::size_t PendingCalls::size() {
    forget_answered();
    return calls_.size();
}

void PendingCalls::forget_answered() {
    std::erase_if(calls_, [](const auto& entry) { return entry.second->answered(); });
}

} // namespace wakesurf::server
