// annotation.set, annotation.delete, annotation.list.
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/record_handlers.hpp"
#include "server/rpc/records_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr RecordHandlers<protocol::AnnotationRecord> handlers{
    "annotation", &Session::annotation, protocol::annotation_json, &Session::delete_annotation};

void set(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto setting =
        protocol::read_annotation_setting(in, {limits::annotation_bytes, limits::name_bytes});
    const std::string gesture = read_gesture(in);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto stale = handlers.stale(**session, setting.annotation, setting.if_rev))
        return reply.fault(*stale);
    const auto record = (*session)->set_annotation(setting, author_of(call, **session, gesture));
    if (!record)
        return reply.fault(record.error());
    reply.result(
        {{"annotation", record->annotation}, {"rev", record->rev}, {"seq", (*session)->seq()}});
}

void remove(const Call& call, Reply reply) {
    handlers.remove(call, std::move(reply));
}

void list(const Call& call, Reply reply) {
    list_records(call, std::move(reply), "annotations", annotations_json);
}

} // namespace

std::vector<Method> annotation_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter if_rev{"ifRev", R"({"type":"integer"})", false,
                           "refuse if the annotation is at another revision"};
    return {
        {"annotation.set",
         "Creates an annotation, a note at a point in space, or replaces one as a whole; it keeps "
         "the name of who made it.",
         {session_parameter(),
          {"annotation", text, false, "left out: create one"},
          {"text", text, true,
           fmt::format("of one line or several, at most {} bytes", limits::annotation_bytes)},
          {"position", R"({"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3})",
           true, "where it points to, in the dataset's unit"},
          {"surface", text, false, "the surface it speaks of"},
          gesture_parameter(),
          if_rev},
         "{annotation, rev, seq}",
         any_editor,
         set},
        {"annotation.delete",
         "Deletes an annotation.",
         {session_parameter(),
          {"annotation", text, true, "an id from annotation.list"},
          gesture_parameter(),
          if_rev},
         "{seq}",
         any_editor,
         remove},
        {"annotation.list",
         "The annotations of a session.",
         {session_parameter()},
         "{annotations}",
         any_viewer,
         list},
    };
}

} // namespace wakesurf::server
