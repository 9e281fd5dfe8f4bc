#include "server/cli/surface_request.hpp"

#include "protocol/api/surface_names.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/cli/rake_text.hpp"

#include <cmath>
#include <filesystem>

namespace wakesurf::server {

namespace {

using Code = core::Error::Code;

core::Result<void> check_words(const SurfaceOptions& options, core::SurfaceParameters& out) {
    const auto kind = protocol::surface_kind(options.kind);
    const auto accuracy = protocol::accuracy(options.accuracy);
    const auto direction = protocol::direction(options.direction);
    if (!kind)
        return core::fail(Code::InvalidArgument,
                          "--kind: '" + options.kind + "' is not a kind of surface",
                          "choose stream, path, streak or time");
    if (!accuracy)
        return core::fail(Code::InvalidArgument,
                          "--accuracy: '" + options.accuracy + "' is not an accuracy",
                          "choose fast, balanced or exact");
    if (!direction)
        return core::fail(Code::InvalidArgument,
                          "--direction: '" + options.direction + "' is not a direction",
                          "choose forward, backward or both");
    out.kind = *kind;
    out.accuracy = *accuracy;
    out.direction = *direction;
    return {};
}

core::Result<void> check_numbers(const SurfaceOptions& options) {
    const auto refuse = [](const char* what) {
        return core::fail(Code::InvalidArgument, std::string(what) + " is not a finite number");
    };
    if (options.from && !std::isfinite(*options.from))
        return refuse("--from");
    if (options.to && !std::isfinite(*options.to))
        return refuse("--to");
    if (!std::isfinite(options.separation))
        return refuse("--separation");
    if (options.separation < 0)
        return core::fail(Code::InvalidArgument, "--separation must not be negative");
    if (options.release_until && !std::isfinite(*options.release_until))
        return refuse("--release-until");
    if (!(options.merge >= 0.0 && options.merge <= 0.5))
        return core::fail(Code::InvalidArgument, "--merge must be between 0 and 0.5",
                          "0 never merges cells, 0.35 is the default");
    if (!(options.angle >= 0.0 && options.angle <= 180.0))
        return core::fail(Code::InvalidArgument, "--angle must be between 0 and 180 degrees",
                          "180 never refines by angle, 20 is the default");
    return {};
}

core::Result<void> check_output(const std::string& output, const char* option, bool mesh) {
    const std::filesystem::path file(output);
    const auto extension = file.extension().string();
    if (mesh && (extension.empty() || !protocol::mesh_format(extension.substr(1))))
        return core::fail(Code::InvalidArgument,
                          std::string(option) + ": '" + output + "' has no known extension",
                          "write " + protocol::mesh_extensions());
    std::error_code ignored;
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, ignored))
        return core::fail(Code::NotFound,
                          std::string(option) + ": there is no folder " + folder.string(),
                          "create it first");
    return {};
}

core::Result<void> usage(const std::string& what, const std::string& hint) {
    return core::fail(Code::InvalidArgument, what, hint);
}

/// What only streak surfaces and only time surfaces have.
core::Result<void> check_kind(const SurfaceOptions& options, core::SurfaceKind kind) {
    const bool time = kind == core::SurfaceKind::Time;
    if (options.release_until && kind != core::SurfaceKind::Streak)
        return usage("--release-until belongs to streak surfaces", "use it with --kind streak");
    if (!options.rake2.empty() && !time)
        return usage("--rake2 belongs to time surfaces", "use it with --kind time");
    if (!options.sweep.empty() && !time)
        return usage("--sweep belongs to time surfaces", "use it with --kind time");
    if (time && options.rake2.empty() == options.sweep.empty())
        return usage("--kind time takes one of --rake2 and --sweep",
                     "as in --rake2 \"0,0,0 0,0,1\" or --sweep 0,1,0");
    return {};
}

core::Result<void> read_patch(const SurfaceOptions& options, core::SurfaceParameters& out) {
    if (!options.rake2.empty()) {
        auto rake = parse_rake(options.rake2, options.seeds, "--rake2");
        if (!rake)
            return tl::unexpected(rake.error());
        out.rake2 = *std::move(rake);
    }
    if (!options.sweep.empty()) {
        const auto sweep = parse_vector(options.sweep, "--sweep");
        if (!sweep)
            return tl::unexpected(sweep.error());
        if (*sweep == core::Vec3(0.0))
            return usage("--sweep: '" + options.sweep + "' has no length", "as in --sweep 0,1,0");
        out.sweep = *sweep;
    }
    return {};
}

} // namespace

core::Result<SurfaceRequest> check_surface_options(const SurfaceOptions& options) {
    SurfaceRequest request;
    if (auto checked = check_words(options, request.parameters); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = check_numbers(options); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = check_kind(options, request.parameters.kind); !checked)
        return tl::unexpected(checked.error());
    auto rake = parse_rake(options.rake, options.seeds);
    if (!rake)
        return tl::unexpected(rake.error());
    request.rake = *std::move(rake);
    if (auto checked = read_patch(options, request.parameters); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = check_output(options.output, "-o", true); !checked)
        return tl::unexpected(checked.error());
    if (!options.draco && std::filesystem::path(options.output).extension() == ".drc")
        return core::fail(Code::InvalidArgument,
                          "--no-draco cannot be used for .drc, which is always Draco",
                          "write .glb");
    if (!options.stats.empty()) {
        if (auto checked = check_output(options.stats, "--stats", false); !checked)
            return tl::unexpected(checked.error());
    }
    request.parameters.separation = options.separation;
    request.parameters.merge = options.merge;
    request.parameters.angle = options.angle;
    request.parameters.max_quads = options.max_quads;
    request.parameters.deformation = true;
    return request;
}

core::Result<void> choose_times(core::SurfaceParameters& parameters,
                                const SurfaceOptions& options,
                                const std::vector<double>& times) {
    const double first = times.empty() ? 0.0 : times.front();
    parameters.from = options.from.value_or(first);
    const double last =
        !times.empty() && times.back() > parameters.from ? times.back() : parameters.from + 10;
    parameters.to = options.to.value_or(last);
    if (parameters.to <= parameters.from)
        return core::fail(Code::InvalidArgument, "--to " + std::to_string(parameters.to) +
                                                     " is not after --from " +
                                                     std::to_string(parameters.from));
    parameters.release_until = options.release_until;
    const double until = options.release_until.value_or(parameters.to);
    if (!(until > parameters.from) || until > parameters.to)
        return core::fail(Code::InvalidArgument,
                          "--release-until " + std::to_string(until) +
                              " does not lie between --from " + std::to_string(parameters.from) +
                              " and --to " + std::to_string(parameters.to),
                          "leave it out to release until --to");
    return {};
}

} // namespace wakesurf::server
