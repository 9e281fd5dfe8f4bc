// bookmark.set, bookmark.delete, bookmark.list, and the same of annotations.
#include "server/net/methods/record_handlers.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

constexpr RecordHandlers<protocol::BookmarkRecord, protocol::BookmarkSetting> bookmark_handlers{
    "bookmark", &Session::set_bookmark};

constexpr RecordHandlers<protocol::AnnotationRecord, protocol::AnnotationSetting>
    annotation_handlers{"annotation", &Session::set_annotation};

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
    return {method(bookmark_set),   method(bookmark_delete),   method(bookmark_list),
            method(annotation_set), method(annotation_delete), method(annotation_list)};
}

} // namespace wakesurf::server
