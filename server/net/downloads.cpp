#include "server/net/downloads.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/base/rounding.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/surface_lines.hpp"
#include "server/base/limits.hpp"
#include "server/base/split.hpp"
#include "server/data/obstacle_file.hpp"
#include "server/data/open_dataset.hpp"
#include "server/data/surface_scalars.hpp"
#include "server/live/body_frames.hpp"
#include "server/live/surface_build.hpp"
#include "server/live/surface_file.hpp"
#include "server/net/asked_surface.hpp"
#include "server/net/download_request.hpp"
#include "server/net/lines_downloads.hpp"
#include "server/net/slice_downloads.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// Returns the time at which the data have the flow for a request at `time`: the same, or the one time of a
/// steady flow. Error: OutOfTime.
core::Result<double> time_in_data(const LoadedDataset& dataset, double time) {
    if (dataset.info.steady)
        return dataset.info.times.empty() ? time : dataset.info.times.front();
    const auto range = dataset.flow->time_range();
    if (!range)
        return time;
    const auto [first, last] = *range;
    if (!core::within_rounding(time, first, last))
        return fail(Error::Code::OutOfTime,
                    fmt::format("time {} is outside the data's {} to {}", time, first, last),
                    "choose `time` inside it");
    return std::clamp(time, first, last);
}

/// Holds the input of a file. Finished meshes are not kept: 100 MB a million quads.
struct FileJob {
    core::SurfacePlan plan;
    std::shared_ptr<const LoadedDataset> dataset;
    protocol::Recipe recipe;
    std::shared_ptr<const core::SurfacePlan> twin;
    const core::MemoryAccount* account;

    core::Result<std::string> make(const std::stop_token& stop,
                                   core::MemoryAccount::Share& share) const {
        return make_surface_file(recipe, plan, *dataset, stop,
                                 {account, &share, limits::download_memory}, {}, twin.get())
            .map([](SurfaceFile&& file) { return std::move(file.bytes); });
    }
};

/// Returns the recipe of what was asked for.
protocol::Recipe recipe_of_download(const core::SurfacePlan& plan,
                                    const LoadedDataset& dataset,
                                    const protocol::SurfaceRecord& record,
                                    const DownloadRequest& request,
                                    std::optional<double> time,
                                    bool coarse) {
    protocol::Recipe recipe = recipe_of(plan, dataset);
    recipe.fields = record.fields;
    if (record.twin && std::ranges::any_of(record.fields, core::is_twin_name)) {
        recipe.twin = record.twin->settings;
        if (record.twin->dataset)
            recipe.unrepeatable = "it was compared with other data, " + *record.twin->dataset;
    }
    recipe.format = protocol::extension(request.format);
    recipe.draco = request.glb == protocol::GlbCoding::Draco;
    recipe.tessellate = request.tessellate;
    recipe.lines = request.lines;
    recipe.time = time;
    recipe.coarse = coarse;
    return recipe;
}

/// Returns a tag that changes with everything that the file's bytes depend on.
/// @param data  identifies the values of the dataset, and its time-steps, of which there may be more later
std::string tag_of(const protocol::SurfaceRecord& record,
                   const SurfaceJob& job,
                   const DownloadRequest& request,
                   std::optional<double> time,
                   const std::optional<SurfacePass>& early,
                   const std::string& data) {
    std::string all = protocol::json_text(protocol::written(record));
    for (const core::Rake* rake :
         {&job.plan.rake, job.plan.parameters.rake2 ? &*job.plan.parameters.rake2 : nullptr})
        if (rake != nullptr) {
            all += fmt::format("|{} {}", int(rake->kind), rake->seeds);
            for (const core::Vec3& p : rake->points)
                all += fmt::format(" {},{},{}", p.x, p.y, p.z);
        }
    all += fmt::format("|{} {}", data, WAKESURF_VERSION);
    all += "|" + request.lines;
    if (request.tessellate > 1)
        all += fmt::format("|tessellate {}", request.tessellate);
    if (early)
        all += fmt::format("|coarse {} {} {}", job.plan.parameters.max_quads,
                           job.plan.parameters.separation, job.plan.parameters.to);
    return fmt::format("\"{}-{}-{:08x}-{}-{}{}\"", record.surface, record.epoch,
                       core::crc32c(std::as_bytes(std::span(all))),
                       time ? fmt::format("{}", *time) : "end", protocol::extension(request.format),
                       request.glb == protocol::GlbCoding::Plain ? "-plain" : "");
}

/// @param name  without its extension
HttpResponse file_response(const std::string& name,
                           protocol::MeshFormat format,
                           const std::string& tag,
                           const File& body) {
    return {200,
            {{"Content-Type", std::string(protocol::content_type(format))},
             {"Content-Disposition",
              fmt::format("attachment; filename=\"{}.{}\"", name, protocol::extension(format))},
             {"Cache-Control", "private, no-cache"},
             {"ETag", tag}},
            body};
}

/// A dataset's files of its body: frames for the page, and a file for other programs.
constexpr std::string_view obstacle_name = "obstacle.bin", body_name = "body.vtp";

} // namespace

Downloads::Downloads(Loop& loop,
                     ComputePool& pool,
                     const SessionDirectory& sessions,
                     const DatasetCatalogue& catalogue,
                     const core::MemoryAccount& account,
                     File viewer)
    : sessions_(sessions), catalogue_(catalogue), account_(account), files_(loop, pool, &account_),
      numbers_(sessions_, catalogue_, account_, files_),
      animations_(sessions_, catalogue_, account_, files_, std::move(viewer)),
      fields_(loop, pool, catalogue_, account_) {}

bool Downloads::handle(const HttpRequest& request,
                       const Identity& identity,
                       const Respond& respond) {
    const auto parts = split(request.path, '/');
    const auto part = [&](std::size_t i) { return std::string(parts[i]); };
    if (parts.size() == 6 && request.path.starts_with("/api/v1/datasets/") &&
        (parts[5] == obstacle_name || parts[5] == body_name))
        obstacle(request, identity, part(4), part(5), respond);
    else if (parts.size() == 6 && request.path.starts_with("/api/v1/datasets/") &&
             parts[5] == slice_file_name)
        fields_.get(request, turns_of("slice", identity), part(4), plan_slice, respond);
    else if (parts.size() == 6 && request.path.starts_with("/api/v1/datasets/") &&
             parts[5] == lines_file_name)
        fields_.get(request, turns_of("lines", identity), part(4), plan_lines, respond);
    else if (parts.size() == 8 && request.path.starts_with("/api/v1/sessions/") &&
             parts[5] == "surfaces" && parts[7] == numbers_file)
        numbers_.get(request, identity, part(4), part(6), respond);
    else if (parts.size() == 8 && request.path.starts_with("/api/v1/sessions/") &&
             parts[5] == "surfaces" && parts[7] == animation_file)
        animations_.get(request, identity, part(4), part(6), respond);
    else if (parts.size() == 8 && request.path.starts_with("/api/v1/sessions/") &&
             parts[5] == "surfaces")
        surface(request, identity, {part(4), part(6), part(7)}, respond);
    else
        return false;
    return true;
}

bool Downloads::replaced(const LoadedDataset& data) const {
    const auto now = catalogue_.find(data.info.dataset);
    return data.store && now && (*now)->store != data.store &&
           !(*now)->store->marks().continues(data.store->marks());
}

void Downloads::obstacle(const HttpRequest& request,
                         const Identity& identity,
                         const std::string& id,
                         const std::string& name,
                         const Respond& respond) {
    const auto dataset = catalogue_.find(id);
    if (!dataset)
        return respond(http_error(dataset.error()));
    const auto asked = url_query(request.query).and_then(read_obstacle);
    if (!asked)
        return respond(http_error(asked.error()));
    std::optional<double> time;
    if (asked->time) {
        const auto there = time_in_data(**dataset, *asked->time);
        if (!there)
            return respond(http_error(there.error()));
        time = *there;
    }
    if (!asked->field.empty())
        if (const auto known = check_fields(**dataset, {asked->field}, "field"); !known)
            return respond(http_error(known.error()));
    const std::string when = time ? fmt::format(" at {} {}", *time, asked->field) : "";
    const std::string tag =
        fmt::format("{} {} {}{} {} {}", name, id, values_of(**dataset), when,
                    static_cast<int>(asked->patches.of), fmt::join(asked->patches.names, "\n"));
    files_.get(
        tag, turns_of("", identity),
        [loaded = *dataset, time, asked = *asked, name,
         &account = account_](const std::stop_token& stop, core::MemoryAccount::Share& share) {
            if (name == obstacle_name)
                return body_frames(*loaded, time, asked.field, asked.patches, account, share, stop);
            std::vector<std::string> fields;
            if (!asked.field.empty())
                fields.push_back(asked.field);
            return obstacle_file(*loaded, {asked.patches, fields, time}, account, share, stop)
                .map([](ObstacleFile file) { return std::move(file.bytes); });
        },
        request.gone,
        [this, respond, request, identity, id, name,
         data = *dataset](const core::Result<File>& file) {
            if (replaced(*data))
                return obstacle(request, identity, id, name, respond);
            if (!file)
                return respond(http_error(file.error()));
            respond({200,
                     {{"Content-Type", "application/octet-stream"}, {"Cache-Control", "no-cache"}},
                     *file});
        });
}

core::Result<void> Downloads::offer(const HttpRequest& request,
                                    const Identity& identity,
                                    const Place& place,
                                    const Respond& respond) {
    const auto query = url_query(request.query);
    if (!query)
        return tl::unexpected(query.error());
    const auto wanted = read_download(place.file, *query);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto asked = find_surface(sessions_, catalogue_, place.session, place.surface);
    if (!asked)
        return tl::unexpected(asked.error());
    const protocol::SurfaceRecord& record = asked->record;
    const LiveSurface& live = *asked->live;
    const auto early = wanted->now ? live.early() : std::nullopt;
    // An error of the surface, for example that a user has stopped it, holds for its file as well.
    if (const auto wrong = live.outcome().error;
        wrong && !(early && wrong->code == Error::Code::Cancelled))
        return tl::unexpected(*wrong);
    SurfaceJob job = live.wanted();
    if (early)
        job.plan = early_plan(std::move(job.plan), *early);
    else // a fast surface would differ for it
        job.plan.parameters.deformation = true;
    job.plan.parameters.tangents =
        wanted->tessellate > 1 || std::ranges::any_of(record.fields, core::is_normal_component);
    if (!wanted->lines.empty())
        if (const auto read =
                protocol::read_lines(wanted->lines, job.plan.parameters.kind, wanted->format);
            !read)
            return tl::unexpected(read.error());
    auto time = shown_at(*wanted, job.plan.parameters, asked->session->clock().time());
    if (!time)
        return tl::unexpected(time.error());
    if (early && job.plan.parameters.kind != core::SurfaceKind::Path)
        time->reset(); // it ends there
    const std::string tag = tag_of(record, job, *wanted, *time, early, asked->data_mark);
    if (request.has(tag)) {
        respond({304, {{"ETag", tag}, {"Cache-Control", "private, no-cache"}}});
        return {};
    }
    const auto stay = asked->session->attendance().stay();
    files_.get(
        tag + place.session, turns_of(place.session, identity),
        [file = FileJob{job.plan, asked->dataset,
                        recipe_of_download(job.plan, *asked->dataset, record, *wanted, *time,
                                           early.has_value()),
                        job.twin, &account_}](const std::stop_token& stop,
                                              core::MemoryAccount::Share& share) {
            return file.make(stop, share);
        },
        request.gone,
        [this, respond, name = place.surface + (early ? "-coarse" : ""), format = wanted->format,
         tag, stay, request, identity, place,
         data = asked->dataset](const core::Result<File>& file) {
            if (replaced(*data)) // while it was made
                return surface(request, identity, place, respond);
            respond(file ? file_response(name, format, tag, *file) : http_error(file.error()));
        });
    return {};
}

void Downloads::surface(const HttpRequest& request,
                        const Identity& identity,
                        const Place& place,
                        const Respond& respond) {
    if (const auto offered = offer(request, identity, place, respond); !offered)
        respond(http_error(offered.error()));
}

} // namespace wakesurf::server
