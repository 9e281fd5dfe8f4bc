// rake.set, rake.delete, rake.list.
#include "protocol/checked_json.hpp"
#include "protocol/messages_rake.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/session_choice.hpp"
#include "server/rpc/stale_revision.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void set(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto setting = protocol::read_rake_setting(
        in, {limits::seeds_least, limits::seeds_most, limits::rake_points, limits::name_bytes});
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (setting.rake)
        if (const auto now = (*session)->rake(*setting.rake))
            if (const auto stale =
                    stale_revision(setting.if_rev, now->rev, protocol::rake_json(*now)))
                return reply.fault(*stale);
    const auto change = (*session)->set_rake(setting);
    if (!change)
        return reply.fault(change.error());
    json surfaces = json::array();
    for (const auto& [surface, epoch] : change->surfaces)
        surfaces.push_back({{"surface", surface}, {"epoch", epoch}});
    reply.result({{"rake", change->record.rake},
                  {"rev", change->record.rev},
                  {"clipped", change->record.clipped},
                  {"points", protocol::points_json(change->record.shape.points)},
                  {"surfaces", std::move(surfaces)}});
}

void remove(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string rake = in.text("rake");
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto done = (*session)->delete_rake(rake); !done)
        return reply.fault(done.error());
    reply.result(json::object());
}

void list(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    json rakes = json::array();
    for (const auto& each : (*session)->rakes())
        rakes.push_back(protocol::rake_json(each));
    reply.result({{"rakes", std::move(rakes)}});
}

} // namespace

std::vector<Method> rake_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter rake{"rake", text, true, "an id from rake.list"};
    return {
        {"rake.set",
         "Creates a rake, or replaces one as a whole; the surfaces that hang on it are rebuilt at "
         "once.",
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
          {"dragging", R"({"type":"boolean"})", false,
           "more edits of this drag follow; told to everybody in the record. Leases are not "
           "offered yet"},
          {"ifRev", R"({"type":"integer"})", false, "refuse if the rake is at another revision"}},
         "{rake, rev, clipped, points, surfaces: [{surface, epoch}]}: points as clipped to the "
         "domain",
         any_editor,
         set},
        {"rake.delete",
         "Deletes a rake and the surfaces that hang on it.",
         {session_parameter(), rake},
         "{}",
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
