// time.set, time.play, time.pause: the clock of a session. It is kept, but its answers do not wait for the
// disk.
#include "protocol/api/generated/time.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

void answer(Session& session, Reply& reply) {
    reply.result({{"clock", protocol::written(session.clock().record())}});
}

void time_set(const Call& call, const protocol::TimeSet& to, Reply reply) {
    const auto session = choose_session(call, to.session);
    if (!session)
        return reply.fault(session.error());
    if (to.time.value)
        if (const auto there = (*session)->builds().check_time("time", *to.time.value); !there)
            return reply.fault(there.error());
    (*session)->clock().set(to.time.value);
    answer(**session, reply);
}

void time_play(const Call& call, const protocol::PlaySetting& setting, Reply reply) {
    const auto session = choose_session(call, setting.session);
    if (!session)
        return reply.fault(session.error());
    for (const auto& [name, time] : {std::pair{"from", setting.from}, {"to", setting.to}})
        if (time)
            if (const auto there = (*session)->builds().check_time(name, *time); !there)
                return reply.fault(there.error());
    if (const auto plays = (*session)->clock().play(setting, (*session)->builds().moving_range());
        !plays)
        return reply.fault(plays.error());
    answer(**session, reply);
}

void time_pause(const Call& call, const protocol::TimePause& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    (*session)->clock().pause();
    answer(**session, reply);
}

} // namespace

std::vector<Method> time_methods() {
    return {method(time_set), method(time_play), method(time_pause)};
}

} // namespace wakesurf::server
