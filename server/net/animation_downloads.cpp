#include "server/net/animation_downloads.hpp"

#include "core/surface/builder/vertex_attributes.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/files/animation_page.hpp"
#include "server/base/limits.hpp"
#include "server/live/animation_file.hpp"
#include "server/net/asked_surface.hpp"
#include "server/net/download_request.hpp"
#include "server/net/static_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace wakesurf::server {

core::Result<AnimationRequest> read_animation(const std::map<std::string, std::string>& query) {
    AnimationRequest out;
    for (const auto& [name, value] : query) {
        if (name == "times") {
            const auto times = read_times(value, "`times`");
            if (!times)
                return tl::unexpected(times.error());
            out.times = *times;
        } else if (name == "look") {
            const auto look = protocol::read_look(value);
            if (!look)
                return tl::unexpected(look.error());
            out.look = *look;
        } else {
            return core::fail(core::Error::Code::InvalidArgument,
                              "an animation has no parameter `" + name.substr(0, 64) + "`",
                              R"(the parameters are ?times=0:5:0.1 and ?look={"map":"inferno"})");
        }
    }
    return out;
}

namespace {

/// Holds the input of a file.
struct AnimationJob {
    core::SurfacePlan plan; ///< of the whole surface
    std::shared_ptr<const LoadedDataset> dataset;
    protocol::Recipe recipe; ///< but for its parameters, which are those until the last time
    File viewer;
    const core::MemoryAccount* account;

    core::Result<std::string> make(const std::stop_token& stop,
                                   core::MemoryAccount::Share& share) const {
        return until(plan, recipe.times.back()).and_then([&](const core::SurfacePlan& shown) {
            protocol::Recipe of = recipe;
            of.rake = shown.rake;
            of.parameters = shown.parameters;
            return make_animation_file(std::move(of), shown, *dataset, *viewer, stop,
                                       {account, &share, limits::download_memory})
                .map([](AnimationFile&& made) { return std::move(made.file.bytes); });
        });
    }
};

/// Returns the fields of the surface that an animation can have: what it is compared with is not in it.
std::vector<std::string> animated_fields(const SurfaceJob& job) {
    std::vector<std::string> out;
    for (const SurfaceField& field : job.fields)
        if (!core::is_twin_name(field.name))
            out.push_back(field.name);
    return out;
}

} // namespace

core::Result<void> AnimationDownloads::offer(const HttpRequest& request,
                                             const Identity& identity,
                                             const std::string& session,
                                             const std::string& surface,
                                             const Respond& respond) {
    const auto wanted = url_query(request.query).and_then(read_animation);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto asked = find_surface(sessions_, catalogue_, session, surface);
    if (!asked)
        return tl::unexpected(asked.error());
    if (const auto wrong = asked->live->outcome().error) // holds for its animation as well
        return tl::unexpected(*wrong);
    if (!viewer_)
        return tl::unexpected(no_animation_viewer());
    SurfaceJob job = asked->live->wanted();
    core::SurfaceParameters& p = job.plan.parameters;
    p.deformation = true;
    p.tangents = std::ranges::any_of(asked->record.fields, core::is_normal_component);
    if (auto moving = check_moves(job.plan, asked->dataset->info); !moving)
        return moving;
    auto times = wanted->times ? times_in(*wanted->times, p, most_steps, "`times`")
                               : core::Result<std::vector<double>>(even_times(p, animation_steps));
    if (!times)
        return tl::unexpected(times.error());
    protocol::Recipe recipe = recipe_of(job.plan, *asked->dataset);
    recipe.fields = animated_fields(job);
    recipe.format = protocol::animation_extension;
    recipe.times = *std::move(times);
    recipe.look = wanted->look;
    // A recipe names all that the bytes depend on, but for what the surface may read of the data later.
    const std::string tag =
        fmt::format("animation|{}|{}|{}|{}|{}", session, surface, asked->record.epoch,
                    protocol::recipe_text(recipe), asked->data_mark);
    const auto stay = asked->session->attendance().stay();
    files_.get(
        tag, turns_of(session, identity),
        [job = AnimationJob{job.plan, asked->dataset, std::move(recipe), viewer_, &account_}](
            const std::stop_token& stop, core::MemoryAccount::Share& share) {
            return job.make(stop, share);
        },
        request.gone,
        [respond, surface, stay](const core::Result<File>& file) {
            if (!file)
                return respond(http_error(file.error()));
            // To be saved: shown from this address, its script would be that of a page of the server.
            respond({200,
                     {{"Content-Type", "text/html; charset=utf-8"},
                      {"Content-Disposition",
                       fmt::format("attachment; filename=\"{}-animation.html\"", surface)},
                      {"Cache-Control", "private, no-cache"}},
                     *file});
        });
    return {};
}

void AnimationDownloads::get(const HttpRequest& request,
                             const Identity& identity,
                             const std::string& session,
                             const std::string& surface,
                             const Respond& respond) {
    if (const auto offered = offer(request, identity, session, surface, respond); !offered)
        respond(http_error(offered.error()));
}

} // namespace wakesurf::server
