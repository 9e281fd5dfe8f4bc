// rake.set, rake.delete, rake.list.
#include "protocol/api/messages_rake.hpp"
#include "server/limits.hpp"
#include "server/rpc/leased.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <fmt/format.h>
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

void set(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto setting = protocol::read_rake_setting(
        in, {limits::seeds_least, limits::seeds_most, limits::rake_points, limits::name_bytes});
    const std::string gesture = read_gesture(in);
    const bool default_scene = in.flag_or("default", false);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    Author author = author_of(call, **session, gesture);
    author.default_scene = default_scene;
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

void remove(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string rake = in.text("rake");
    const auto if_rev = in.count_if("ifRev", 0, protocol::most_rev);
    const bool force = in.flag_or("force", false);
    const std::string gesture = read_gesture(in);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    const Author author = author_of(call, **session, gesture);
    if (const auto refused = refusal(**session, rake, author, if_rev, force, call))
        return reply.fault(*refused);
    if (const auto done = (*session)->delete_rake(rake, author); !done)
        return reply.fault(done.error());
    reply.result({{"seq", (*session)->seq()}});
}

void list(const Call& call, Reply reply) {
    list_records(call, std::move(reply), "rakes", rakes_json);
}

} // namespace

std::vector<Method> rake_methods() {
    const char* text = R"({"type":"string"})";
    const char* flag = R"({"type":"boolean"})";
    const Parameter rake{"rake", text, true, "an id from rake.list"};
    const Parameter if_rev{"ifRev", R"({"type":"integer"})", false,
                           "refuse if the rake is at another revision"};
    return {
        {"rake.set",
         "Creates a rake, or replaces one as a whole; the surfaces that hang on it are rebuilt at "
         "once, unless only its name or colour changes.",
         {session_parameter(),
          {"rake", text, false, "left out: create one"},
          {"kind", R"({"enum":["line","polyline","circle","points"]})", true, "shape of the rake"},
          {"points",
           fmt::format(
               R"({{"type":"array","maxItems":{},"items":{{"type":"array","items":{{"type":"number"}},"minItems":3,"maxItems":3}}}})",
               limits::rake_points),
           true,
           "line: 2; polyline and points: 2 or more; circle: centre and two points of the rim"},
          {"seeds",
           fmt::format(R"({{"type":"integer","minimum":{},"maximum":{}}})", limits::seeds_least,
                       limits::seeds_most),
           true, "how many seeds lie on it"},
          {"name", text, false, "for people"},
          {"colour", R"({"type":"string","pattern":"^#[0-9a-fA-F]{6}$"})", false,
           "#rrggbb; left out: as it was, of a new rake one that few others have"},
          {"dragging", flag, false,
           fmt::format("true: no one else may edit the rake for {} s from now; false: they may "
                       "again; left out: as it was",
                       limits::lease.count() / 1000)},
          {"force", R"({"type":"boolean","default":false})", false,
           "a host's edit goes before someone else's lease"},
          default_parameter(),
          gesture_parameter(),
          if_rev},
         "{rake, rev, seq, clipped, points, surfaces: [{surface, epoch}]}: points as clipped to "
         "the "
         "domain",
         any_editor,
         set},
        {"rake.delete",
         "Deletes a rake and the surfaces that hang on it.",
         {session_parameter(),
          rake,
          {"force", R"({"type":"boolean","default":false})", false,
           "although someone else drags it"},
          gesture_parameter(),
          if_rev},
         "{seq}",
         any_editor,
         remove},
        {"rake.list",
         "The rakes of a session.",
         {session_parameter()},
         "{rakes}",
         any_viewer,
         list},
    };
}

} // namespace wakesurf::server
