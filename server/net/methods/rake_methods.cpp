// rake.set, rake.delete, rake.list.
#include "protocol/api/base/point_json.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/record_handlers.hpp"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Returns a point in time to the millisecond, RFC 3339.
std::string utc_text(std::chrono::system_clock::time_point time) {
    const auto ms = std::chrono::time_point_cast<std::chrono::milliseconds>(time);
    const auto seconds = std::chrono::floor<std::chrono::seconds>(ms);
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), (ms - seconds).count());
}

/// Returns a fault that says by whom the rake is dragged just now and until when, or nothing where the author
/// may edit it.
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
        std::make_shared<const json>(
            json{{"by", lease->by.participant},
                 {"name", lease->by.name},
                 {"until", utc_text(std::chrono::system_clock::now() + lease->left)},
                 {"untilMs", lease->left.count()}})};
}

/// Says why the author may not edit a rake as it is now: another participant drags it, or it is at another
/// revision.
std::optional<protocol::RpcFault> refusal(Session& session,
                                          const std::string& rake,
                                          const Author& author,
                                          std::optional<std::uint64_t> if_rev,
                                          bool force,
                                          const Call& call) {
    const auto now = session.records().get<protocol::RakeRecord>(rake);
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
    return stale_revision(if_rev, now->rev, protocol::record_json(*now));
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
    const auto surfaces = protocol::list_json(change->surfaces, [](const auto& each) {
        return json{{"surface", each.first}, {"epoch", each.second}};
    });
    reply.result({{"rake", change->record.rake},
                  {"rev", change->record.rev},
                  {"seq", (*session)->seq()},
                  {"clipped", change->record.clipped},
                  {"points", protocol::points_json(change->record.shape.points)},
                  {"surfaces", surfaces}});
}

void rake_delete(const Call& call, const protocol::RakeDelete& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    const Author author = author_of(call, **session, of.gesture);
    if (const auto refused = refusal(**session, of.rake, author, of.if_rev, of.force, call))
        return reply.fault(*refused);
    if (const auto done = (*session)->remove({RecordType::Rake, of.rake}, author); !done)
        return reply.fault(done.error());
    reply_with_seq(std::move(reply), **session);
}

void rake_list(const Call& call, const protocol::RakeList& of, Reply reply) {
    list_records<protocol::RakeRecord>(call, of.session, std::move(reply), "rakes");
}

} // namespace

std::vector<Method> rake_methods() {
    return {method(rake_set), method(rake_delete), method(rake_list)};
}

} // namespace wakesurf::server
