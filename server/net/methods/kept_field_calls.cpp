#include "server/net/methods/kept_field_calls.hpp"

#include "server/base/forecast.hpp"
#include "server/net/methods/work_progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Says how far one is, with a forecast.
class KeptFieldProgress {
  public:
    KeptFieldProgress(std::string subject,
                      std::string done,
                      std::shared_ptr<const core::WorkDone> work,
                      const core::Clock& clock)
        : subject_(std::move(subject)), done_(std::move(done)), work_(std::move(work)),
          clock_(clock), began_(clock.now()) {}

    json progress_json() {
        const std::chrono::duration<double> gone = clock_.now() - began_;
        forecast_.add(gone.count(), work_->fraction());
        const int percent = static_cast<int>(std::floor(100.0 * work_->fraction()));
        json out{{"message", fmt::format("{}: {} % {}", subject_, percent, done_)},
                 {"percentage", percent}};
        if (const auto left = forecast_.left())
            out["remaining"] = *left;
        return out;
    }

  private:
    std::string subject_, done_;
    std::shared_ptr<const core::WorkDone> work_;
    const core::Clock& clock_;
    std::chrono::steady_clock::time_point began_;
    Forecast forecast_;
};

/// Lives from the call to its answer.
struct Making {
    explicit Making(Reply to) : reply(std::move(to)) {}

    Reply reply;
    Budgets::Permit permit;
    std::optional<WorkProgress> progress;
};

std::optional<protocol::RpcFault> refused_here(const Call& call) {
    if (call.context.kept_fields == nullptr)
        return protocol::fault_of(core::Error{core::Error::Code::Unsupported,
                                              "this server makes no fields from others", ""});
    return std::nullopt;
}

} // namespace

void make_kept_field(const Call& call,
                     const std::string& dataset,
                     KeptFieldWords words,
                     KeptFieldJobs::Make make,
                     Reply reply) {
    if (const auto why = refused_here(call))
        return reply.fault(*why);
    auto permit = take(call, Use::Wait);
    if (!permit)
        return reply.fault(permit.error());
    const auto making = std::make_shared<Making>(std::move(reply));
    making->permit = std::move(*permit);
    const auto work = std::make_shared<core::WorkDone>();
    const auto token = work_token(call, words.token);
    if (token && call.client != nullptr)
        making->progress.emplace(call, *token, std::move(words.title),
                                 [progress = std::make_shared<KeptFieldProgress>(
                                      std::move(words.subject), std::move(words.done), work,
                                      call.context.clock)] { return progress->progress_json(); });
    call.context.kept_fields->run(dataset,
                                  {std::move(words.what), std::move(make), call.stop, work},
                                  [making](const core::Result<json>& made) {
                                      making->progress.reset();
                                      if (!made)
                                          return making->reply.fault(made.error());
                                      making->reply.result(*made);
                                  });
}

void remove_kept_field(const Call& call,
                       const std::string& dataset,
                       std::function<core::Result<void>(const LoadedDataset&)> remove,
                       Reply reply) {
    if (const auto why = refused_here(call))
        return reply.fault(*why);
    const auto answer = std::make_shared<Reply>(std::move(reply));
    const auto make = [remove = std::move(remove)](const LoadedDataset& open, const auto&,
                                                   const auto&) {
        return remove(open).map([] { return json(json::object()); });
    };
    call.context.kept_fields->run(dataset, {"this", make},
                                  [answer](const core::Result<json>& gone) {
                                      if (!gone)
                                          return answer->fault(gone.error());
                                      answer->result(*gone);
                                  });
}

} // namespace wakesurf::server
