#include "server/net/methods/work_progress.hpp"

#include "protocol/api/base/json_text.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <utility>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr std::chrono::milliseconds between_reports{100};

} // namespace

std::optional<std::string> work_token(const Call& call, const std::optional<std::string>& given) {
    // Without a way to stop it, nothing would say that the caller has gone.
    return call.stop.stop_possible() ? given : std::nullopt;
}

WorkProgress::WorkProgress(const Call& call, std::string token, std::string title, Measure measure)
    : client_(*call.client), loop_(call.context.loop), stop_(call.stop), token_(std::move(token)),
      measure_(std::move(measure)) {
    tell({{"kind", "begin"}, {"message", std::move(title)}, {"cancellable", true}});
    arm();
}

WorkProgress::~WorkProgress() {
    if (stop_.stop_requested())
        return;
    json value = measure_();
    value["kind"] = "end";
    tell(std::move(value));
}

void WorkProgress::tell(json value) {
    client_.notify(protocol::rpc_notification(
        "$/progress", {{"token", json::parse(token_)}, {"value", std::move(value)}}));
}

void WorkProgress::arm() {
    timer_ = loop_.after(between_reports, [this] { report(); });
}

void WorkProgress::report() {
    if (stop_.stop_requested())
        return;
    json value = measure_();
    if (std::string text = protocol::json_text(value); text != sent_) {
        sent_ = std::move(text);
        value["kind"] = "report";
        tell(std::move(value));
    }
    arm();
}

} // namespace wakesurf::server
