// surface.set, .delete, .stop, .list.
#include "server/net/methods/method.hpp"
#include "server/net/methods/record_handlers.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

constexpr RecordHandlers<protocol::SurfaceRecord, protocol::SurfaceSetting> surface_handlers{
    "surface", &Session::set_surface};

/// Where `from` is left out; what is wrong with the dataset is told later.
double usual_start(const Call& call, const protocol::SurfaceSetting& asked) {
    const auto open = call.context.datasets.open(asked.dataset);
    if (!open || open->info.times.empty())
        return 0.0;
    const auto& times = open->info.times;
    return asked.parameters.direction == core::Direction::Backward ? times.back() : times.front();
}

void surface_set(const Call& call, const protocol::SurfaceSetting& asked, Reply reply) {
    protocol::SurfaceSetting setting = asked;
    setting.parameters.from = asked.from ? *asked.from : usual_start(call, asked);
    const auto session = choose_session(call, setting.session);
    if (!session)
        return reply.fault(session.error());
    if (const auto stale = surface_handlers.stale(**session, setting.surface, setting.if_rev))
        return reply.fault(*stale);
    Author author = author_of(call, **session, setting.gesture);
    author.default_scene = setting.default_scene;
    const auto record = (*session)->set_surface(setting, author);
    if (!record)
        return reply.fault(record.error());
    reply.result({{"surface", record->surface},
                  {"rev", record->rev},
                  {"epoch", record->epoch},
                  {"seq", (*session)->seq()}});
}

void surface_delete(const Call& call, const protocol::SurfaceDelete& of, Reply reply) {
    surface_handlers.remove(call, of, of.surface, std::move(reply));
}

/// Any editor may: the surface is everyone's, and so is the time it takes.
void surface_stop(const Call& call, const protocol::SurfaceStop& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    const auto live = (*session)->live(of.surface);
    if (!live)
        return reply.fault(live.error());
    const bool stopped =
        (*live)->stop({core::Error::Code::Cancelled,
                       "stopped by " + author_of(call, **session).name + " before it was complete",
                       "change the surface or its rake, or set it again, to have it computed"});
    reply.result({{"epoch", (*live)->epoch()}, {"stopped", stopped}});
}

void surface_list(const Call& call, const protocol::SurfaceList& of, Reply reply) {
    list_records<protocol::SurfaceRecord>(call, of.session, std::move(reply), "surfaces");
}

} // namespace

std::vector<Method> surface_methods() {
    return {method(surface_set), method(surface_delete), method(surface_stop),
            method(surface_list)};
}

} // namespace wakesurf::server
