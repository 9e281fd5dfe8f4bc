// rake.set, rake.delete, rake.list.
#include "protocol/api/base/point_json.hpp"
#include "server/rpc/leased.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Why the author may not edit a rake as it is now: somebody else drags it, or it is at another revision.
std::optional<protocol::RpcFault> refusal(Session& session,
                                          const std::string& rake,
                                          const Author& author,
                                          std::optional<std::uint64_t> if_rev,
                                          bool force,
                                          const Call& call) {
    const auto now = session.rake(rake);
    if (!now)
        return protocol::fault_of(now.error());
    if (force && !is_host(call, session))
        return protocol::RpcFault{protocol::RpcCode::NotPermitted,
                                  "only a host of the session may use `force`",
                                  "wait a few seconds: a lease ends by itself",
                                  {},
                                  {}};
    if (!force)
        if (auto held = leased(session, rake, author))
            return held;
    return stale_revision(if_rev, now->rev, protocol::rake_json(*now));
}

void rake_set(const Call& call, const protocol::RakeSetting& setting, Reply reply) {
    const auto session = choose_session(call, setting.session);
    if (!session)
        return reply.fault(session.error());
    Author author = author_of(call, **session, setting.gesture);
    author.default_scene = setting.default_scene;
    if (setting.rake)
        if (const auto refused =
                refusal(**session, *setting.rake, author, setting.if_rev, setting.force, call))
            return reply.fault(*refused);
    const auto change = (*session)->set_rake(setting, author);
    if (!change)
        return reply.fault(change.error());
    json surfaces = json::array();
    for (const auto& [surface, epoch] : change->surfaces)
        surfaces.push_back({{"surface", surface}, {"epoch", epoch}});
    reply.result({{"rake", change->record.rake},
                  {"rev", change->record.rev},
                  {"seq", (*session)->seq()},
                  {"clipped", change->record.clipped},
                  {"points", protocol::points_json(change->record.shape.points)},
                  {"surfaces", std::move(surfaces)}});
}

void rake_delete(const Call& call, const protocol::RakeDelete& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    const Author author = author_of(call, **session, of.gesture);
    if (const auto refused = refusal(**session, of.rake, author, of.if_rev, of.force, call))
        return reply.fault(*refused);
    if (const auto done = (*session)->delete_rake(of.rake, author); !done)
        return reply.fault(done.error());
    reply_with_seq(std::move(reply), **session);
}

void rake_list(const Call& call, const protocol::RakeList& of, Reply reply) {
    list_records(call, of.session, std::move(reply), "rakes", rakes_json);
}

} // namespace

std::vector<Method> rake_methods() {
    return {method(rake_set), method(rake_delete), method(rake_list)};
}

} // namespace wakesurf::server
