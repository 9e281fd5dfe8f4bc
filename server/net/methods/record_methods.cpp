// The methods on records: rakes, surfaces, slices, streamlines, bookmarks and annotations. What every type of record shares (a list, a deletion, a setter that may be
// meant for one revision only) comes first.
#include "protocol/api/base/list_json.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/records_json.hpp"

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace wakesurf::server {

namespace {

/// Answers a deletion: {seq}
void reply_with_seq(Reply reply, const Session& session) {
    reply.result({{"seq", session.seq()}});
}

/// Returns a fault that carries the current record, or nothing where its revision is the one that `ifRev`
/// expects.
std::optional<protocol::RpcFault> stale_revision(std::optional<std::uint64_t> expected,
                                                 std::uint64_t rev,
                                                 const nlohmann::json& record) {
    if (!expected || *expected == rev)
        return std::nullopt;
    return protocol::RpcFault{
        protocol::RpcCode::Stale,
        "the record is at revision " + std::to_string(rev) + ", not " + std::to_string(*expected),
        "apply the edit to data.current and send it again",
        {},
        std::make_shared<const nlohmann::json>(nlohmann::json{{"current", record}})};
}

using nlohmann::json;

/// The name and the setter of a type of record.
template <class R, class Setting>
struct RecordHandlers {
    const char* type; ///< the member with its id
    core::Result<R> (Session::*put)(const Setting& setting, const Author& author);

    /// Says why an edit is refused that was meant for another revision.
    std::optional<protocol::RpcFault> stale(const Session& session,
                                            const std::optional<std::string>& id,
                                            std::optional<std::uint64_t> if_rev) const {
        const R* const now = id ? session.records().find<R>(*id) : nullptr;
        return now != nullptr ? stale_revision(if_rev, now->rev, protocol::written(*now))
                              : std::nullopt;
    }

    /// Sets the record `id`, or a new one, and answers {TYPE, rev, seq}.
    void set(const Call& call,
             const Setting& setting,
             const std::optional<std::string>& id,
             Reply reply) const {
        const auto session = choose_session(call, setting.session);
        if (!session)
            return reply.fault(session.error());
        if (const auto refused = stale(**session, id, setting.if_rev))
            return reply.fault(*refused);
        const auto record =
            ((**session).*put)(setting, author_of(call, **session, setting.gesture));
        if (!record)
            return reply.fault(record.error());
        reply.result(
            {{type, key_of(*record).id}, {"rev", record->rev}, {"seq", (*session)->seq()}});
    }

    /// Deletes the record `id`. `parameters` have session, gesture and ifRev beside the id.
    template <class Parameters>
    void remove(const Call& call,
                const Parameters& parameters,
                const std::string& id,
                Reply reply) const {
        const auto session = choose_session(call, parameters.session);
        if (!session)
            return reply.fault(session.error());
        if (const auto refused = stale(**session, id, parameters.if_rev))
            return reply.fault(*refused);
        const Author author = author_of(call, **session, parameters.gesture);
        if (const auto done = (*session)->remove({type_of_record<R>, id}, author); !done)
            return reply.fault(done.error());
        reply_with_seq(std::move(reply), **session);
    }
};

/// Answers {NAME: all records of the type}.
template <class R>
void list_records(const Call& call,
                  const std::optional<std::string>& named,
                  Reply reply,
                  const char* name) {
    const auto session = choose_session(call, named);
    if (!session)
        return reply.fault(session.error());
    reply.result({{name, all_json<R>(**session)}});
}

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
        "wait until it is released, or edit another rake; a host may use `force`",
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
    return stale_revision(if_rev, now->rev, protocol::written(*now));
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
                  {"points", protocol::written(change->record.shape.points)},
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

void set_surface(const Call& call, const protocol::SurfaceSetting& setting, Reply reply) {
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

void surface_set(const Call& call, const protocol::SurfaceSetting& asked, Reply reply) {
    protocol::SurfaceSetting setting = asked;
    setting.parameters.from = asked.from ? *asked.from : usual_start(call, asked);
    set_surface(call, setting, std::move(reply));
}

void surface_twin(const Call& call, const protocol::SurfaceTwin& asked, Reply reply) {
    const auto record = choose_session(call, asked.session).and_then([&](const auto& session) {
        return session->records().template get<protocol::SurfaceRecord>(asked.surface);
    });
    if (!record)
        return reply.fault(record.error());
    protocol::SurfaceSetting setting;
    setting.session = asked.session;
    setting.surface = asked.surface;
    setting.rake = record->rake;
    setting.rake2 = record->rake2;
    setting.dataset = record->dataset;
    setting.parameters = record->parameters;
    setting.from = record->parameters.from;
    setting.twin = asked.twin;
    setting.fields = record->fields;
    setting.gesture = asked.gesture;
    setting.if_rev = asked.if_rev;
    set_surface(call, setting, std::move(reply));
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
    return {method(surface_set), method(surface_twin), method(surface_delete), method(surface_stop),
            method(surface_list)};
}

namespace {

constexpr RecordHandlers<protocol::BookmarkRecord, protocol::BookmarkSetting> bookmark_handlers{
    "bookmark", &Session::set_bookmark};

constexpr RecordHandlers<protocol::AnnotationRecord, protocol::AnnotationSetting>
    annotation_handlers{"annotation", &Session::set_annotation};

constexpr RecordHandlers<protocol::SliceRecord, protocol::SliceSetting> slice_handlers{
    "slice", &Session::set_slice};

void slice_set(const Call& call, const protocol::SliceSetting& setting, Reply reply) {
    slice_handlers.set(call, setting, setting.slice, std::move(reply));
}

void slice_delete(const Call& call, const protocol::SliceDelete& of, Reply reply) {
    slice_handlers.remove(call, of, of.slice, std::move(reply));
}

void slice_list(const Call& call, const protocol::SliceList& of, Reply reply) {
    list_records<protocol::SliceRecord>(call, of.session, std::move(reply), "slices");
}

constexpr RecordHandlers<protocol::LinesRecord, protocol::LinesSetting> lines_handlers{
    "lines", &Session::set_lines};

void lines_set(const Call& call, const protocol::LinesSetting& setting, Reply reply) {
    lines_handlers.set(call, setting, setting.lines, std::move(reply));
}

void lines_delete(const Call& call, const protocol::LinesDelete& of, Reply reply) {
    lines_handlers.remove(call, of, of.lines, std::move(reply));
}

void lines_list(const Call& call, const protocol::LinesList& of, Reply reply) {
    list_records<protocol::LinesRecord>(call, of.session, std::move(reply), "lines");
}

void bookmark_set(const Call& call, const protocol::BookmarkSetting& setting, Reply reply) {
    bookmark_handlers.set(call, setting, setting.bookmark, std::move(reply));
}

void bookmark_delete(const Call& call, const protocol::BookmarkDelete& of, Reply reply) {
    bookmark_handlers.remove(call, of, of.bookmark, std::move(reply));
}

void bookmark_list(const Call& call, const protocol::BookmarkList& of, Reply reply) {
    list_records<protocol::BookmarkRecord>(call, of.session, std::move(reply), "bookmarks");
}

void annotation_set(const Call& call, const protocol::AnnotationSetting& setting, Reply reply) {
    annotation_handlers.set(call, setting, setting.annotation, std::move(reply));
}

void annotation_delete(const Call& call, const protocol::AnnotationDelete& of, Reply reply) {
    annotation_handlers.remove(call, of, of.annotation, std::move(reply));
}

void annotation_list(const Call& call, const protocol::AnnotationList& of, Reply reply) {
    list_records<protocol::AnnotationRecord>(call, of.session, std::move(reply), "annotations");
}

} // namespace

std::vector<Method> mark_methods() {
    return {method(slice_set),      method(slice_delete),      method(slice_list),
            method(lines_set),      method(lines_delete),      method(lines_list),
            method(bookmark_set),   method(bookmark_delete),   method(bookmark_list),
            method(annotation_set), method(annotation_delete), method(annotation_list)};
}

} // namespace wakesurf::server
