#include "server/cli/surface_request.hpp"

#include "protocol/surface_names.hpp"
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
                          "--kind: '" + options.kind + "' is no kind of surface",
                          "one of stream, path, streak, time");
    if (!accuracy)
        return core::fail(Code::InvalidArgument,
                          "--accuracy: '" + options.accuracy + "' is no accuracy",
                          "one of fast, balanced, exact");
    if (!direction)
        return core::fail(Code::InvalidArgument,
                          "--direction: '" + options.direction + "' is no direction",
                          "one of forward, backward, both");
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
        return core::fail(Code::InvalidArgument, "--separation is negative");
    return {};
}

core::Result<void> check_output(const std::string& output, const char* option, bool mesh) {
    const std::filesystem::path file(output);
    const auto extension = file.extension().string();
    if (mesh && (extension == ".glb" || extension == ".ply" || extension == ".obj"))
        return core::fail(Code::Unsupported,
                          std::string(option) + ": this version of wakesurf does not write " +
                              extension,
                          "write .vtp");
    if (mesh && extension != ".vtp")
        return core::fail(Code::InvalidArgument,
                          std::string(option) + ": '" + output + "' has no known extension",
                          "write .vtp");
    std::error_code ignored;
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, ignored))
        return core::fail(Code::NotFound,
                          std::string(option) + ": there is no folder " + folder.string(),
                          "make it first");
    return {};
}

core::Result<void> check_supported(const SurfaceOptions& options, core::SurfaceKind kind) {
    const auto unsupported = [](const std::string& what) {
        return core::fail(Code::Unsupported, "this version of wakesurf does not have " + what,
                          "stream and path surfaces of one rake work");
    };
    if (kind == core::SurfaceKind::Streak || kind == core::SurfaceKind::Time)
        return unsupported(std::string(protocol::name(kind)) + " surfaces");
    if (options.release_until)
        return unsupported("--release-until");
    if (!options.rake2.empty())
        return unsupported("--rake2");
    if (!options.sweep.empty())
        return unsupported("--sweep");
    if (!options.fields.empty())
        return unsupported("--fields");
    return {};
}

} // namespace

core::Result<SurfaceRequest> check_surface_options(const SurfaceOptions& options) {
    SurfaceRequest request;
    if (auto checked = check_words(options, request.parameters); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = check_numbers(options); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = check_supported(options, request.parameters.kind); !checked)
        return tl::unexpected(checked.error());
    auto rake = parse_rake(options.rake, options.seeds);
    if (!rake)
        return tl::unexpected(rake.error());
    request.rake = *std::move(rake);
    if (auto checked = check_output(options.output, "-o", true); !checked)
        return tl::unexpected(checked.error());
    if (!options.stats.empty()) {
        if (auto checked = check_output(options.stats, "--stats", false); !checked)
            return tl::unexpected(checked.error());
    }
    request.parameters.separation = options.separation;
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
                                                     " does not lie after --from " +
                                                     std::to_string(parameters.from));
    return {};
}

} // namespace wakesurf::server
