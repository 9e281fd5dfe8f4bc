#include "server/rpc/quota.hpp"

#include "server/limits.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr std::array<std::pair<std::string_view, std::size_t>, 9> quotas{{
    {"session.create", limits::sessions},
    {"session.fork", limits::sessions},
    {"session.join", limits::participants},
    {"session.share", limits::grants},
    {"rake.set", limits::rakes},
    {"surface.set", limits::surfaces},
    {"bookmark.set", limits::bookmarks},
    {"annotation.set", limits::annotations},
    {"probe.sample", limits::probes},
}};

json quota_of(std::string_view method) {
    for (const auto& [name, most] : quotas)
        if (name == method)
            return most;
    return nullptr;
}

} // namespace

protocol::RpcFault with_limit(const protocol::RpcFault& fault, std::string_view method) {
    json detail = fault.detail && fault.detail->is_object() ? *fault.detail : json::object();
    if (!detail.contains("limit"))
        detail["limit"] = quota_of(method);
    protocol::RpcFault out = fault;
    out.detail = std::make_shared<const json>(std::move(detail));
    return out;
}

} // namespace wakesurf::server
