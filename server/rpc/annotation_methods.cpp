// annotation.set, annotation.delete, annotation.list.
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

constexpr RecordHandlers<protocol::AnnotationRecord> annotation_handlers{
    "annotation", &Session::annotation, protocol::annotation_json, &Session::delete_annotation};

void annotation_set(const Call& call, const protocol::AnnotationSetting& setting, Reply reply) {
    const auto session = choose_session(call, setting.session);
    if (!session)
        return reply.fault(session.error());
    if (const auto stale = annotation_handlers.stale(**session, setting.annotation, setting.if_rev))
        return reply.fault(*stale);
    const auto record =
        (*session)->set_annotation(setting, author_of(call, **session, setting.gesture));
    if (!record)
        return reply.fault(record.error());
    reply.result(
        {{"annotation", record->annotation}, {"rev", record->rev}, {"seq", (*session)->seq()}});
}

void annotation_delete(const Call& call, const protocol::AnnotationDelete& of, Reply reply) {
    annotation_handlers.remove(call, of, of.annotation, std::move(reply));
}

void annotation_list(const Call& call, const protocol::AnnotationList& of, Reply reply) {
    list_records(call, of.session, std::move(reply), "annotations", annotations_json);
}

} // namespace

std::vector<Method> annotation_methods() {
    return {method(annotation_set), method(annotation_delete), method(annotation_list)};
}

} // namespace wakesurf::server
