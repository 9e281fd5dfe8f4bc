#include "server/rpc/leased.hpp"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace wakesurf::server {

namespace {

std::string utc_text(std::chrono::system_clock::time_point time) {
    const auto ms = std::chrono::time_point_cast<std::chrono::milliseconds>(time);
    const auto seconds = std::chrono::floor<std::chrono::seconds>(ms);
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), (ms - seconds).count());
}

} // namespace

std::optional<protocol::RpcFault>
leased(const Session& session, const std::string& rake, const Author& author) {
    const auto lease = session.lease(rake);
    if (!lease || lease->by.participant == author.participant)
        return std::nullopt;
    return protocol::RpcFault{
        protocol::RpcCode::Leased,
        "rake " + rake + " is being dragged by " + lease->by.name,
        "wait until it is let go, or edit another rake; a host may use `force`",
        {},
        std::make_shared<const nlohmann::json>(
            nlohmann::json{{"by", lease->by.participant},
                           {"name", lease->by.name},
                           {"until", utc_text(std::chrono::system_clock::now() + lease->left)},
                           {"untilMs", lease->left.count()}})};
}

} // namespace wakesurf::server
