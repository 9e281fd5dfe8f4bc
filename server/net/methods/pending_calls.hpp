// The calls of one WebSocket that are not answered yet, so that `$/cancelRequest` can name one: it is
// answered as cancelled at once, its work is asked to stop, and what the work still answers goes nowhere.
#pragma once

#include "protocol/api/json_rpc.hpp"

#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class PendingCall {
  public:
    using Answer = std::function<void(std::string)>;

    PendingCall(protocol::RpcId id, Answer answer)
        : id_(std::move(id)), answer_(std::move(answer)) {}

    /// The first answer counts.
    void answer(std::string text);

    /// Answers with -32800 and stops the work; nothing once there is an answer.
    void cancel();

    /// Stops the work, whose answer no client can receive any more.
    void abandon();

    std::stop_token stop() const { return stop_.get_token(); }

    /// Fires before stop() does, and only where the caller asked for it.
    std::stop_token cancelled() const { return cancelled_.get_token(); }

    bool answered() const { return answer_ == nullptr; }

  private:
    protocol::RpcId id_;
    Answer answer_;
    std::stop_source stop_;
    std::stop_source cancelled_;
};

/// Loop thread only.
class PendingCalls {
  public:
    PendingCalls() = default;

    ~PendingCalls() { abandon(); }

    PendingCalls(const PendingCalls&) = delete;
    PendingCalls& operator=(const PendingCalls&) = delete;

    /// Nothing when as many are open as may be. Two with one id are cancelled together.
    std::shared_ptr<PendingCall> open(const protocol::RpcId& id, PendingCall::Answer answer);

    /// An id that is not open is ignored: its answer may be on the way.
    void cancel(const protocol::RpcId& id);

    /// Stops the work of all; none is answered.
    void abandon();

    std::size_t size();

  private:
    void forget_answered();

    std::multimap<protocol::RpcId, std::shared_ptr<PendingCall>> calls_;
};

} // namespace wakesurf::server
