#include "server/net/downloads.hpp"

#include "core/surface/obstacle_surface.hpp"
#include "core/surface/surface_builder.hpp"
#include "protocol/bytes.hpp"
#include "protocol/mesh_encoder.hpp"
#include "protocol/mesh_file.hpp"
#include "server/catalogue/surface_scalars.hpp"
#include "server/limits.hpp"
#include "server/net/http_error.hpp"
#include "server/session/background.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

using File = std::shared_ptr<const std::string>;
using Body = core::Result<File>;

std::vector<std::string> split(std::string_view path) {
    std::vector<std::string> parts;
    while (!path.empty()) {
        const auto slash = std::min(path.find('/'), path.size());
        parts.emplace_back(path.substr(0, slash));
        path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return parts;
}

/// What of a dataset particles stop at, to look at: the surface of the solid nodes, or the
/// walls of the store or of a built-in flow.
core::Result<core::QuadComplex> obstacle_of(const LoadedDataset& dataset) {
    const auto none =
        fail(Error::Code::NotFound, "the dataset has no obstacle", "dataset.describe says so");
    const core::StoreReader* store = dataset.store.get();
    if (store != nullptr && !store->mask().empty())
        return core::obstacle_surface(store->grid(), store->mask());
    const auto walls = store != nullptr ? store->load_walls() : dataset.flow->walls();
    if (!walls)
        return tl::unexpected(walls.error());
    if (walls->triangles.empty())
        return none;
    return core::wall_surface(*walls);
}

/// Frames, each preceded by its length.
Body obstacle_frames(const LoadedDataset& dataset) {
    const auto mesh = obstacle_of(dataset);
    if (!mesh)
        return tl::unexpected(mesh.error());
    protocol::EncodeOptions options;
    options.final = true;
    options.attributes = false;
    const auto state =
        protocol::encode_state(*mesh, protocol::lattice_over(dataset.info.bounds), options);
    if (!state)
        return tl::unexpected(state.error());
    auto out = std::make_shared<std::string>();
    for (const auto& frame : state->frames) {
        protocol::Bytes length;
        protocol::append(length, static_cast<std::uint32_t>(frame->size()));
        out->append(reinterpret_cast<const char*>(length.data()), length.size());
        out->append(reinterpret_cast<const char*>(frame->data()), frame->size());
    }
    return out;
}

/// Builds the surface again, which gives the same bytes: keeping every finished mesh would cost 100 MB a million quads.
Body surface_file(const SurfaceJob& job,
                  const LoadedDataset& dataset,
                  const std::vector<std::string>& fields,
                  protocol::MeshFormat format,
                  const std::stop_token& stop) {
    core::SurfaceParameters parameters = job.parameters;
    parameters.deformation = true;
    const auto surface = core::build_surface(*job.flow, job.rake, parameters, stop);
    if (!surface)
        return tl::unexpected(surface.error());
    const auto scalars = surface_scalars(dataset, *surface, parameters, fields, stop);
    if (!scalars)
        return tl::unexpected(scalars.error());
    protocol::MeshMetadata metadata{.kind = parameters.kind,
                                    .rake = job.rake.points,
                                    .from = parameters.from,
                                    .to = parameters.to,
                                    .separation = parameters.separation,
                                    .dataset = dataset.info.dataset,
                                    .version = WAKESURF_VERSION,
                                    .release_until = parameters.release_until,
                                    .sweep = parameters.sweep};
    if (parameters.rake2)
        metadata.rake2 = parameters.rake2->points;
    return protocol::mesh_file(format, surface->mesh, metadata, *scalars)
        .map([](std::string&& bytes) {
            return std::make_shared<const std::string>(std::move(bytes));
        });
}

/// From `mesh.ply`.
std::optional<protocol::MeshFormat> format_of(std::string_view file) {
    constexpr std::string_view stem = "mesh.";
    return file.starts_with(stem) ? protocol::mesh_format(file.substr(stem.size())) : std::nullopt;
}

/// Whether an If-None-Match names this tag; weak ones count (RFC 9110, 13.1.2).
bool names(std::string_view if_none_match, std::string_view tag) {
    return if_none_match == "*" || if_none_match.find(tag) != std::string_view::npos;
}

HttpResponse file_response(const SurfaceOutcome& outcome,
                           protocol::MeshFormat format,
                           const std::string& tag,
                           const File& body) {
    return {200,
            {{"Content-Type", std::string(protocol::content_type(format))},
             {"Content-Disposition", fmt::format("attachment; filename=\"{}.{}\"", outcome.surface,
                                                 protocol::extension(format))},
             {"Cache-Control", "private, no-cache"},
             {"ETag", tag}},
            body};
}

/// One of the downloads that are computed at a time.
class Place {
  public:
    explicit Place(std::size_t& taken) : taken_(taken) { ++taken_; }

    ~Place() { --taken_; }

    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

  private:
    std::size_t& taken_;
};

} // namespace

struct Downloads::State {
    Loop& loop;
    ComputePool& pool;
    const SessionDirectory& sessions;
    const DatasetCatalogue& catalogue;
    std::stop_source stop;
    std::map<std::string, std::shared_ptr<const std::string>> obstacles;
    std::size_t computing = 0;
};

Downloads::Downloads(Loop& loop,
                     ComputePool& pool,
                     const SessionDirectory& sessions,
                     const DatasetCatalogue& catalogue)
    : state_(new State{loop, pool, sessions, catalogue, {}, {}, 0}) {}

Downloads::~Downloads() {
    state_->stop.request_stop();
}

bool Downloads::handle(const HttpRequest& request, const Respond& respond) {
    const auto parts = split(request.path);
    if (parts.size() < 6 || !parts[0].empty() || parts[1] != "api" || parts[2] != "v1")
        return false;
    if (parts.size() == 6 && parts[3] == "datasets" && parts[5] == "obstacle.bin")
        obstacle(parts[4], respond);
    else if (parts.size() == 8 && parts[3] == "sessions" && parts[5] == "surfaces")
        surface(request, parts[4], parts[6], parts[7], respond);
    else
        return false;
    return true;
}

void Downloads::obstacle(const std::string& id, const Respond& respond) {
    const auto send = [respond](const std::shared_ptr<const std::string>& body) {
        respond({200,
                 {{"Content-Type", "application/octet-stream"}, {"Cache-Control", "no-cache"}},
                 body});
    };
    if (const auto known = state_->obstacles.find(id); known != state_->obstacles.end())
        return send(known->second);
    const auto dataset = state_->catalogue.find(id);
    if (!dataset)
        return respond(http_error(dataset.error()));
    compute<File>(
        state_->loop, state_->pool, [loaded = *dataset] { return obstacle_frames(*loaded); },
        [state = state_, id, respond, send](const Body& body) {
            if (!body)
                return respond(http_error(body.error()));
            state->obstacles[id] = *body;
            send(*body);
        });
}

void Downloads::surface(const HttpRequest& request,
                        const std::string& session_id,
                        const std::string& surface_id,
                        const std::string& file,
                        const Respond& respond) {
    const auto format = format_of(file);
    if (!format)
        return respond(
            http_error(404, "there is no such file", "ask for mesh" + protocol::mesh_extensions()));
    const auto session = state_->sessions.find(session_id);
    if (!session)
        return respond(http_error(session.error()));
    const auto live = (*session)->live(surface_id);
    const auto record = (*session)->surface(surface_id);
    if (!live || !record)
        return respond(http_error(record.error()));
    const auto dataset = state_->catalogue.find(record->dataset);
    if (!dataset)
        return respond(http_error(dataset.error()));
    const std::string known(request.header("if-none-match"));
    (*live)->wait(
        (*live)->epoch(), std::chrono::milliseconds(limits::wait_ms),
        [=, live = *live, state = state_, record = *record, dataset = *dataset,
         format = *format](const core::Result<SurfaceOutcome>& outcome) {
            if (!outcome)
                return respond(http_error(outcome.error()));
            if (!outcome->complete)
                return respond(
                    http_error(503, "the surface is not complete yet", "ask again later"));
            const std::string tag =
                fmt::format("\"{}-{}-{}-{:08x}-{}\"", outcome->surface, record.rev, outcome->epoch,
                            outcome->crc, protocol::extension(format));
            if (names(known, tag))
                return respond({304, {{"ETag", tag}, {"Cache-Control", "private, no-cache"}}});
            if (state->computing >= limits::downloads)
                return respond(http_over_limit(
                    503, limits::downloads,
                    fmt::format("{} downloads are being made already", limits::downloads),
                    "ask again in a few seconds"));
            compute<File>(
                state->loop, state->pool,
                [job = live->wanted(), dataset, fields = record.fields, format,
                 stop = state->stop.get_token()] {
                    return surface_file(job, *dataset, fields, format, stop);
                },
                [respond, outcome = *outcome, tag, format, state,
                 place = std::make_shared<Place>(state->computing)](const Body& body) {
                    respond(body ? file_response(outcome, format, tag, *body)
                                 : http_error(body.error()));
                });
        });
}

} // namespace wakesurf::server
