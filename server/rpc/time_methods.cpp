// time.set, time.play, time.pause: the clock of a session.
#include "protocol/api/checked_json.hpp"
#include "protocol/api/messages_time.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/session_choice.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

void answer(Session& session, Reply& reply) {
    reply.result({{"clock", protocol::clock_json(session.clock().record())}});
}

void set(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto time = protocol::read_clock_time(in, call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    (*session)->clock().set(time);
    answer(**session, reply);
}

void play(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto setting = protocol::read_play_setting(in, limits::clock_speed);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto plays = (*session)->clock().play(setting, (*session)->moving_range()); !plays)
        return reply.fault(plays.error());
    answer(**session, reply);
}

void pause(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    (*session)->clock().pause();
    answer(**session, reply);
}

} // namespace

std::vector<Method> time_methods() {
    const char* number = R"({"type":"number"})";
    const Parameter session = session_parameter();
    const std::string result = "{clock: {time, playing, speed, loop, from, to}}";
    // It is kept, but nobody waits for the disk.
    const MethodTraits editor{Role::Editor, false, false};
    return {
        {"time.set",
         "Jumps to a time: path, streak and time surfaces are shown as they are then, within their "
         "own "
         "`from` and `to`.",
         {session,
          {"time", R"({"type":["number","null"]})", true,
           "simulation time; null: no time, surfaces are shown at their end"}},
         result,
         editor,
         set},
        {"time.play",
         "Lets the clock run, from where it stands or from the start.",
         {session,
          {"speed", R"({"type":"number","exclusiveMinimum":0})", false,
           "simulation time a second; left out: as before, at first 1"},
          {"loop", R"({"type":"boolean"})", false, "begin again at the end"},
          {"from", number, false, "left out: as before, at first where the first surface begins"},
          {"to", number, false, "left out: as before, at first where the last surface ends"}},
         result,
         editor,
         play},
        {"time.pause", "Stops the clock where it is.", {session}, result, editor, pause},
    };
}

} // namespace wakesurf::server
