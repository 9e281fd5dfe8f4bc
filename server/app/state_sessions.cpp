// Sessions of a state folder that no server uses, by the code of the server.
#include "server/app/session_server.hpp"
#include "server/app/tell.hpp"
#include "server/base/limits.hpp"
#include "server/net/io_loop.hpp"
#include "server/net/methods/dispatcher.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/session_files.hpp"
#include "server/sessions/journal/kept_sessions.hpp"
#include "server/sessions/journal/sqlite_journal.hpp"
#include "server/sessions/session_restoring.hpp"

#include <boost/asio/io_context.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <functional>
#include <optional>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// Has no data: surfaces stay parameters, and nothing is computed.
class NoDatasets final : public Datasets {
  public:
    std::vector<std::string> ids() const override { return {}; }

    core::Result<OpenDataset> open(const std::string& id) const override {
        return fail(Error::Code::NotFound, "no dataset `" + id + "` is open here",
                    "serve it to look at its surfaces");
    }
};

class StateSessions final : public SessionServer {
  public:
    StateSessions(KeptSessions kept, bool changes)
        : kept_(std::move(kept)),
          journal_(changes ? std::make_unique<SqliteJournal>(loop_, std::move(kept_.store), nullptr)
                           : nullptr),
          grants_({loop_, clock_, entropy_, unix_seconds, journal_.get()}),
          sessions_({loop_, pool_, datasets_, entropy_, nullptr, journal_.get(), &clock_}),
          dispatcher_(method_table(),
                      {sessions_, datasets_, [] { return nlohmann::json::array(); }, prober_,
                       grants_, clock_, loop_, journal_.get()},
                      {limits::message_bytes, limits::message_depth, limits::batch}),
          files_(loop_, pool_, sessions_, datasets_, journal_.get()) {
        const auto restored =
            restore_sessions(std::exchange(kept_.sessions, {}), sessions_, grants_);
        for (const RestoredSessions::Refused& each : restored.refused)
            tell(stderr, "wakesurf: {}: kept aside: {}\n", each.session, each.record.why);
        sessions_.on_gone([this](const std::string& id) { grants_.forget(id); });
    }

    core::Result<Answer>
    ask(const std::string& method, const std::string& path, const std::string& body) override {
        std::optional<Answer> answer;
        HttpRequest request;
        request.method = method;
        request.path = path;
        request.body = body;
        const Respond respond = [&answer](const HttpResponse& response) {
            answer = {response.status, *response.body};
        };
        if (path == "/rpc")
            dispatcher_.dispatch(body, {}, nullptr, [&answer](std::string text) {
                answer = {200, std::move(text)};
            });
        else if (method == "POST")
            files_.post(request, {}, respond);
        else if (!files_.get(request, respond))
            answer = Answer{404, "{}"};
        while (!answer)
            context_.run_one();
        return std::move(*answer);
    }

  private:
    KeptSessions kept_;
    SystemEntropy entropy_;
    core::SteadyClock clock_;
    boost::asio::io_context context_{1};
    IoLoop loop_{context_};
    NoDatasets datasets_;
    ComputePool pool_{1};
    Prober prober_{loop_, pool_};
    std::unique_ptr<SqliteJournal> journal_; ///< null: read-only
    Grants grants_;
    SessionDirectory sessions_;
    Dispatcher dispatcher_;
    SessionFiles files_;
};

} // namespace

core::Result<std::unique_ptr<SessionServer>> sessions_in(const std::filesystem::path& folder,
                                                         bool changes) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "sessions.sqlite", ignored))
        return fail(Error::Code::NotFound, "there are no sessions in " + folder.string(),
                    "give the folder that `wakesurf serve --state` was given");
    auto kept = KeptSessions::open(folder);
    if (!kept && kept.error().code == Error::Code::OverLimit)
        return fail(Error::Code::OverLimit, "a running server keeps its sessions in this folder",
                    "ask that server: --url with the address it printed when it started, "
                    "http://HOST:PORT/#token=...");
    if (!kept)
        return tl::unexpected(kept.error());
    return std::make_unique<StateSessions>(std::move(*kept), changes);
}

} // namespace wakesurf::server
