#include "server/net/session_files.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/api/session_file.hpp"
#include "server/base/limits.hpp"
#include "server/base/secret.hpp"
#include "server/base/split.hpp"
#include "server/live/compute/background.hpp"
#include "server/net/methods/session_import.hpp"
#include "server/sessions/records/thumbnail.hpp"
#include "server/sessions/session_exchange.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>
#include <utility>

namespace wakesurf::server {

namespace {

using Text = std::shared_ptr<const std::string>;

/// Returns the picture in base64. Error: NotFound if the session is neither open nor in the trash.
core::Result<std::string> thumbnail_of(const SessionDirectory& sessions, const std::string& id) {
    const TrashedSession* deleted = sessions.trash().find(id);
    if (deleted == nullptr)
        return sessions.find(id).map([](const auto& session) { return session->thumbnail(); });
    for (const JournalEntry& each : deleted->entries)
        if (each.type == "thumbnail" && each.record && each.record->size() > 2)
            return each.record->substr(1, each.record->size() - 2); // in quotes, as JSON
    return std::string();
}

HttpResponse picture(const std::string& base64, const HttpRequest& request) {
    const auto image = read_thumbnail(base64);
    if (base64.empty() || !image)
        return http_error(404, "this session has no picture yet", "`session.thumbnail` sends one");
    const std::string tag = '"' + digest_text(secret_digest(image->bytes)).substr(0, 32) + '"';
    HttpResponse response{
        200,
        {{"Content-Type", image->type}, {"Cache-Control", "private, no-cache"}, {"ETag", tag}}};
    if (request.has(tag))
        response.status = 304;
    else
        response.body = std::make_shared<const std::string>(image->bytes);
    return response;
}

} // namespace

SessionFiles::SessionFiles(Loop& loop,
                           ComputePool& pool,
                           SessionDirectory& sessions,
                           const Datasets& datasets,
                           Journal* journal)
    : loop_(loop), pool_(pool), sessions_(sessions), datasets_(datasets), journal_(journal) {}

bool SessionFiles::get(const HttpRequest& request, const Respond& respond) {
    const auto parts = split(request.path, '/');
    if (parts.size() != 6 || !request.path.starts_with("/api/v1/sessions/"))
        return false;
    const std::string id(parts[4]);
    if (parts[5] == "thumbnail") {
        const auto base64 = thumbnail_of(sessions_, id);
        respond(base64 ? picture(*base64, request) : http_error(base64.error()));
        return true;
    }
    if (parts[5] != "session.json")
        return false;
    if (const auto session = sessions_.find(id); session)
        send_file(**session, respond);
    else
        respond(http_error(session.error()));
    return true;
}

void SessionFiles::send_file(const Session& session, const Respond& respond) {
    compute<Text>(
        loop_, pool_,
        [snapshot = snapshot_of(session, datasets_, sessions_.unix_time())] {
            const auto file = protocol::session_file_json(file_of(snapshot));
            return std::make_shared<const std::string>(protocol::json_text(file) + "\n");
        },
        [respond, id = session.id()](const core::Result<Text>& text) {
            if (!text)
                return respond(http_error(text.error()));
            respond({200,
                     {{"Content-Type", "application/json"},
                      {"Content-Disposition", "attachment; filename=\"" + id + ".session.json\""},
                      {"Cache-Control", "no-store"}},
                     *text});
        });
}

void SessionFiles::post(const HttpRequest& request,
                        const Identity& identity,
                        const Respond& respond) {
    if (!identity.grant.empty())
        return respond(http_error(403, "a share link does not allow making a session",
                                  "use the token wakesurf printed when it was started"));
    if (imports_ >= limits::session_imports)
        return respond(http_over_limit(503, limits::session_imports,
                                       "other sessions are being imported now",
                                       "try again in a second"));
    ++imports_;
    compute<std::shared_ptr<ReadSession>>(
        loop_, pool_,
        [text = request.body]() -> core::Result<std::shared_ptr<ReadSession>> {
            return read_session_text(text).map(
                [](ReadSession&& read) { return std::make_shared<ReadSession>(std::move(read)); });
        },
        [this, respond](const core::Result<std::shared_ptr<ReadSession>>& read) {
            --imports_;
            if (!read)
                return respond(http_error(read.error()));
            auto made = import_session(sessions_, datasets_, std::move(**read), {});
            if (!made)
                return respond(http_error(made.error()));
            if (journal_ == nullptr)
                return respond(http_json(protocol::json_text(*made)));
            journal_->settled([respond, answer = *made](const core::Result<void>& kept) mutable {
                answer["durable"] = kept.has_value();
                if (!kept)
                    answer["hint"] = kept.error().message + ": " + kept.error().hint;
                respond(http_json(protocol::json_text(answer)));
            });
        });
}

} // namespace wakesurf::server
