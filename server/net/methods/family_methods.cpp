// family.make, family.remove.
#include "protocol/api/dataset_json.hpp"
#include "protocol/api/generated/family.hpp"
#include "server/base/forecast.hpp"
#include "server/net/methods/family_jobs.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/work_progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <optional>

namespace wakesurf::server {

using nlohmann::json;

namespace {

core::Error parameter(const std::string& name, const std::string& problem) {
    return {core::Error::Code::InvalidArgument, "`" + name + "` " + problem, ""};
}

core::Result<core::FamilyRequest> family_request(const protocol::FamilyMake& of) {
    core::FamilyRequest request;
    request.accuracy = of.accuracy;
    request.length = of.length.value_or(0.0);
    if (!of.scalar.empty())
        request.scalar = of.scalar;
    const bool plane = of.from == "plane";
    const bool curve = of.from == "curve";
    if (plane != of.point.has_value() || plane != of.normal.has_value())
        return tl::unexpected(parameter(of.point ? "normal" : "point",
                                        "is missing or not allowed: a plane needs `point` and "
                                        "`normal`, and nothing else has them"));
    if (curve != of.points.has_value() || curve != of.rake_kind.has_value())
        return tl::unexpected(parameter(of.points ? "rakeKind" : "points",
                                        "is missing or not allowed: a curve needs `points` and "
                                        "`rakeKind`, and nothing else has them"));
    if (curve && !of.scalar.empty())
        return tl::unexpected(parameter(
            "scalar", "is for inflow and plane only: that of a curve is the distance from it"));
    if (plane)
        request.source = core::FamilyPlane{*of.point, *of.normal};
    if (curve) {
        core::Rake rake;
        rake.kind = *of.rake_kind;
        rake.points = *of.points;
        request.source = std::move(rake);
    }
    return request;
}

/// Says how far one is, with a forecast.
class FamilyProgress {
  public:
    FamilyProgress(std::string name,
                   std::shared_ptr<const core::WorkDone> work,
                   const core::Clock& clock)
        : name_(std::move(name)), work_(std::move(work)), clock_(clock), began_(clock.now()) {}

    json progress_json() {
        const std::chrono::duration<double> gone = clock_.now() - began_;
        forecast_.add(gone.count(), work_->fraction());
        const int percent = static_cast<int>(std::floor(100.0 * work_->fraction()));
        json out{{"message", fmt::format("{}: {} % of the nodes traced", name_, percent)},
                 {"percentage", percent}};
        if (const auto left = forecast_.left())
            out["remaining"] = *left;
        return out;
    }

  private:
    std::string name_;
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
    if (call.context.families == nullptr)
        return protocol::fault_of(
            core::Error{core::Error::Code::Unsupported, "this server makes no families", ""});
    return std::nullopt;
}

void family_make(const Call& call, const protocol::FamilyMake& of, Reply reply) {
    auto request = family_request(of);
    if (!request)
        return reply.fault(request.error());
    if (const auto why = refused_here(call))
        return reply.fault(*why);
    auto permit = take(call, Use::Wait);
    if (!permit)
        return reply.fault(permit.error());
    const auto making = std::make_shared<Making>(std::move(reply));
    making->permit = std::move(*permit);
    const auto work = std::make_shared<core::WorkDone>();
    const auto token = work_token(call, of.work_done_token);
    if (token && call.client != nullptr)
        making->progress.emplace(
            call, *token, "making the family " + of.name,
            [progress = std::make_shared<FamilyProgress>(of.name, work, call.context.clock)] {
                return progress->progress_json();
            });
    FamilyWish wish{of.name, std::move(*request), {}};
    if (of.time)
        wish.times = {*of.time};
    if (!call.identity.grant.empty()) // which links cannot remove
        wish.most = families_of_links;
    call.context.families->make(of.dataset, std::move(wish), call.stop, work,
                                [making](const core::Result<core::FamilyRecord>& made) {
                                    making->progress.reset();
                                    if (!made)
                                        return making->reply.fault(made.error());
                                    making->reply.result(protocol::written(*made));
                                });
}

void family_remove(const Call& call, const protocol::FamilyRemove& of, Reply reply) {
    if (const auto why = refused_here(call))
        return reply.fault(*why);
    const auto answer = std::make_shared<Reply>(std::move(reply));
    call.context.families->remove(of.dataset, of.name,
                                  [answer](const core::Result<std::string>& gone) {
                                      if (!gone)
                                          return answer->fault(gone.error());
                                      answer->result(json::object());
                                  });
}

} // namespace

std::vector<Method> family_methods() {
    return {method(family_make), method(family_remove)};
}

} // namespace wakesurf::server
