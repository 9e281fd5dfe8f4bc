// surface.set, .delete, .stop, .list.
#include "protocol/api/messages_surface.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr RecordHandlers<protocol::SurfaceRecord> handlers{
    "surface", &Session::surface, protocol::surface_json, &Session::delete_surface};

/// Without `from` it is the dataset's first time; what is wrong with the dataset is told later.
json with_from(const Call& call) {
    json out = call.parameters;
    if (!out.value("from", json()).is_null())
        return out;
    out["from"] = 0.0;
    if (const auto dataset = out.find("dataset"); dataset != out.end() && dataset->is_string())
        if (const auto open = call.context.datasets.open(dataset->get<std::string>());
            open && !open->info.times.empty())
            out["from"] = open->info.times.front();
    return out;
}

void set(const Call& call, Reply reply) {
    const json parameters = with_from(call);
    protocol::CheckedJson in(parameters);
    const auto setting = protocol::read_surface_setting(
        in, {limits::quads_default, limits::quads_most, limits::fields});
    if (in.has("separation") && setting.parameters.separation == 0.0) // of a record: the default
        in.fault("separation", "must be a number greater than 0");
    const std::string gesture = read_gesture(in);
    const bool default_scene = in.flag_or("default", false);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto stale = handlers.stale(**session, setting.surface, setting.if_rev))
        return reply.fault(*stale);
    Author author = author_of(call, **session, gesture);
    author.default_scene = default_scene;
    const auto record = (*session)->set_surface(setting, author);
    if (!record)
        return reply.fault(record.error());
    reply.result({{"surface", record->surface},
                  {"rev", record->rev},
                  {"epoch", record->epoch},
                  {"seq", (*session)->seq()}});
}

void remove(const Call& call, Reply reply) {
    handlers.remove(call, std::move(reply));
}

/// Any editor may: the surface is everybody's, and so is the time it takes.
void stop(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string surface = in.text("surface");
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    const auto live = (*session)->live(surface);
    if (!live)
        return reply.fault(live.error());
    const bool stopped =
        (*live)->stop({core::Error::Code::Cancelled,
                       "stopped by " + author_of(call, **session).name + " before it was complete",
                       "change the surface or its rake, or set it again, to have it computed"});
    reply.result({{"epoch", (*live)->epoch()}, {"stopped", stopped}});
}

void list(const Call& call, Reply reply) {
    list_records(call, std::move(reply), "surfaces", surfaces_json);
}

std::vector<Parameter> set_parameters() {
    const char* text = R"({"type":"string"})";
    const char* number = R"({"type":"number"})";
    return {
        session_parameter(),
        {"surface", text, false, "left out: create one"},
        {"rake", text, true, "an id from rake.list"},
        {"kind", R"({"enum":["stream","path","streak","time"]})", true,
         "stream: the field frozen at `from`"},
        {"dataset", text, true, "an id from dataset.list"},
        {"from", number, false,
         "time of release; streak: of the first one; left out: the dataset's first time"},
        {"to", number, true, "time the surface is shown until"},
        {"direction", R"({"enum":["forward","backward","both"],"default":"forward"})", false,
         "which way in time particles go"},
        {"releaseUntil", number, false, "streak: the release stops here; left out: `to`"},
        {"sweep", R"({"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3})", false,
         "time: the patch is the rake swept along this vector"},
        {"rake2", text, false, "time: or it lies between the rake and this one"},
        {"separation", number, false, "longest edge; left out: the dataset's finest spacing"},
        {"accuracy", R"({"enum":["fast","balanced","exact"],"default":"balanced"})", false,
         "of the integration, and of how vertices are put in"},
        {"merge", R"({"type":"number","minimum":0,"maximum":0.5,"default":0.35})", false,
         "cells merge below this part of the separation, 0: never"},
        {"angle", R"({"type":"number","minimum":0,"maximum":180,"default":20})", false,
         "cells that meet at more degrees are refined, 180: never"},
        {"maxQuads",
         fmt::format(R"({{"type":"integer","minimum":1,"maximum":{},"default":{}}})",
                     limits::quads_most, limits::quads_default),
         false, "cells to build at most"},
        {"fields",
         fmt::format(R"({{"type":"array","items":{{"type":"string"}},"maxItems":{},"default":[]}})",
                     limits::fields),
         false,
         "further attributes of the vertices, in frames and exports: scalar fields of the dataset, "
         "its velocity (the "
         "magnitude), `deformation`, `approximated`, "
         "`vorticity` (its magnitude), `q_criterion`"},
        default_parameter(),
        gesture_parameter(),
        {"ifRev", R"({"type":"integer"})", false, "refuse if the surface is at another revision"}};
}

} // namespace

std::vector<Method> surface_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter surface{"surface", text, true, "an id from surface.list"};
    const Parameter session = session_parameter();
    return {
        {"surface.set",
         "Creates a surface, or replaces its record as a whole, and starts building it.",
         set_parameters(), "{surface, rev, epoch, seq}", any_editor, set},
        {"surface.delete",
         "Deletes a surface.",
         {session,
          surface,
          gesture_parameter(),
          {"ifRev", R"({"type":"integer"})", false, "refuse if it is at another revision"}},
         "{seq}",
         any_editor,
         remove},
        {"surface.stop",
         "Stops computing a surface, for everyone. What is there of it stays, and its statistics "
         "and "
         "surface.done say who stopped it; the next edit computes it again. `stopped` is false "
         "when "
         "nothing was under way.",
         {session, surface},
         "{epoch, stopped}",
         {Role::Editor, false, false}, // no record changes
         stop},
        {"surface.list", "The surfaces of a session.", {session}, "{surfaces}", any_viewer, list},
    };
}

} // namespace wakesurf::server
