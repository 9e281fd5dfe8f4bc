#include "server/net/number_downloads.hpp"

#include "core/base/clock.hpp"
#include "core/surface/measures/numbers_over_time.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/time_direction.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/files/numbers_csv.hpp"
#include "server/base/limits.hpp"
#include "server/base/split.hpp"
#include "server/data/open_dataset.hpp"
#include "server/data/region_text.hpp"
#include "server/data/surface_scalars.hpp"
#include "server/net/asked_surface.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;

core::Result<NumbersRequest> read_numbers(const std::map<std::string, std::string>& query) {
    NumbersRequest out;
    std::map<std::string, std::string> shown;
    for (const auto& [name, value] : query) {
        if (name == "times") {
            const auto times = read_times(value, "`times`");
            if (!times)
                return tl::unexpected(times.error());
            out.times = *times;
        } else if (name == "through") {
            const auto region = parse_region(value, "`through`");
            if (!region)
                return tl::unexpected(region.error());
            out.through = *region;
        } else if (name == "fields") {
            // A velocity of three scalars is called "u, v, w".
            out.fields = lines_of(value);
            if (out.fields.size() > limits::probe_fields)
                return fail(Error::Code::InvalidArgument,
                            fmt::format("`fields` names more than {}", limits::probe_fields),
                            "leave some out");
        } else if (name == "time") {
            shown.emplace(name, value);
        } else {
            return fail(Error::Code::InvalidArgument,
                        "numbers have no parameter `" + name.substr(0, 64) + "`",
                        "the parameters are ?time=2.5, ?time=end, ?times=0:5:0.1 and "
                        "?through=plane:0,0,0:1,0,0 or box:0,0,0:1,1,1 and ?fields=p, several with "
                        "%0A between them");
        }
    }
    if (out.times && !shown.empty())
        return fail(Error::Code::InvalidArgument, "`time` and `times` exclude each other",
                    "leave one out");
    return read_download("mesh.vtp", shown).map([&](const DownloadRequest& when) {
        out.shown = when;
        return out;
    });
}

namespace {

/// Holds the input of a file.
struct NumbersJob {
    core::SurfacePlan plan;
    std::shared_ptr<const LoadedDataset> dataset; ///< keeps what the plan needs
    std::vector<double> times;
    std::optional<core::Region> through;
    std::vector<core::AveragedField> fields;
    const core::MemoryAccount* account;

    core::Result<std::string> make(const std::stop_token& stop,
                                   core::MemoryAccount::Share& share) const {
        core::WorkMemory memory(*account, stop, limits::download_memory,
                                "the numbers of this surface");
        return core::numbers_over_time(plan, times, through, fields, core::SteadyClock{}, stop,
                                       {nullptr, &memory})
            .and_then([&](const core::NumberTable& table) -> core::Result<std::string> {
                std::string text = protocol::numbers_csv(table, dataset->info.length_unit,
                                                         dataset->info.time_unit);
                if (!share.grow_to(text.size()))
                    return tl::unexpected(account->refusal("a file of numbers", text.size()));
                return text;
            });
    }
};

} // namespace

core::Result<void> NumberDownloads::offer(const HttpRequest& request,
                                          const Identity& identity,
                                          const std::string& session_id,
                                          const std::string& surface,
                                          const Respond& respond) {
    const auto wanted = url_query(request.query).and_then(read_numbers);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto asked = find_surface(sessions_, catalogue_, session_id, surface);
    if (!asked)
        return tl::unexpected(asked.error());
    if (const auto wrong = asked->live->outcome().error) // holds for its numbers as well
        return tl::unexpected(*wrong);
    auto fields = averaged_fields(*asked->dataset, wanted->fields);
    if (!fields)
        return tl::unexpected(fields.error());
    NumbersJob job{asked->live->wanted().plan, asked->dataset, {}, wanted->through,
                   *std::move(fields),         &account_};
    const core::SurfaceParameters& p = job.plan.parameters;
    if (wanted->times) {
        auto times = times_in(*wanted->times, p, most_numbers_times, "`times`");
        if (!times)
            return tl::unexpected(times.error());
        job.times = *std::move(times);
    } else {
        const auto time = shown_at(wanted->shown, p, asked->session->clock().time());
        if (!time)
            return tl::unexpected(time.error());
        job.times = {time->value_or(p.to)};
    }
    const std::string tag = fmt::format(
        "numbers|{}|{}|{}|{}|{}|{}", session_id, surface, asked->record.epoch,
        protocol::json_text(protocol::written(asked->record)), asked->data_mark,
        wanted->times ? request.query : fmt::format("{} {}", request.query, job.times.front()));
    const auto stay = asked->session->attendance().stay();
    files_.get(
        tag, turns_of(session_id, identity),
        [job = std::move(job)](const std::stop_token& stop, core::MemoryAccount::Share& share) {
            return job.make(stop, share);
        },
        request.gone,
        [respond, surface, stay](const core::Result<File>& file) {
            if (!file)
                return respond(http_error(file.error()));
            respond({200,
                     {{"Content-Type", "text/csv; charset=utf-8"},
                      {"Content-Disposition",
                       fmt::format("attachment; filename=\"{}-numbers.csv\"", surface)},
                      {"Cache-Control", "private, no-cache"}},
                     *file});
        });
    return {};
}

void NumberDownloads::get(const HttpRequest& request,
                          const Identity& identity,
                          const std::string& session,
                          const std::string& surface,
                          const Respond& respond) {
    if (const auto offered = offer(request, identity, session, surface, respond); !offered)
        respond(http_error(offered.error()));
}

} // namespace wakesurf::server
