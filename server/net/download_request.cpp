#include "server/net/download_request.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/patches/tessellation.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "core/surface/time_direction.hpp"
#include "server/live/surface_build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

std::optional<std::string> decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i] == '+' ? ' ' : text[i];
            continue;
        }
        unsigned char byte = 0;
        const std::string_view digits = text.substr(i + 1, 2);
        const char* const end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, byte, 16);
        if (digits.size() != 2 || read.ec != std::errc{} || read.ptr != end)
            return std::nullopt;
        out += static_cast<char>(byte);
        i += 2;
    }
    return out;
}

} // namespace

core::Result<std::map<std::string, std::string>> url_query(std::string_view text) {
    std::map<std::string, std::string> out;
    while (!text.empty()) {
        const auto end = std::min(text.find('&'), text.size());
        const std::string_view part = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto equals = part.find('=');
        const auto name = decoded(part.substr(0, equals));
        const auto value =
            equals == std::string_view::npos ? std::nullopt : decoded(part.substr(equals + 1));
        if (!name || !value || !out.emplace(*name, *value).second)
            return fail(Error::Code::InvalidArgument, "the address has a query that cannot be read",
                        "write ?name=value&name=value, each name once");
    }
    return out;
}

std::optional<double> finite_number(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

namespace {

core::Result<void> read_time(const std::string& text, DownloadRequest& out) {
    out.at_the_end = text == "end";
    out.time = finite_number(text);
    if (out.at_the_end || out.time)
        return {};
    return fail(Error::Code::InvalidArgument, "`time` is neither a finite number nor `end`",
                "as in ?time=2.5; left out, it is the time of the session's clock");
}

core::Result<void> read_now(const std::string& text, DownloadRequest& out) {
    if (text != "true" && text != "false")
        return fail(Error::Code::InvalidArgument, "`now` is neither true nor false",
                    "?now=true returns what is shown, also where it is not final yet");
    out.now = text == "true";
    return {};
}

core::Result<void> read_draco(const std::string& text, DownloadRequest& out) {
    if (text != "true" && text != "false")
        return fail(Error::Code::InvalidArgument, "`draco` is neither true nor false",
                    "?draco=false returns a .glb that readers without Draco can open");
    if (text == "false" && out.format == protocol::MeshFormat::Drc)
        return fail(Error::Code::InvalidArgument, "a .drc file is always compressed with Draco",
                    "ask for mesh.glb");
    out.glb = text == "false" ? protocol::GlbCoding::Plain : protocol::GlbCoding::Draco;
    return {};
}

core::Result<void> read_tessellate(const std::string& text, DownloadRequest& out) {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, out.tessellate);
    if (read.ec != std::errc{} || read.ptr != end || out.tessellate < 1 ||
        out.tessellate > core::most_tessellated)
        return fail(
            Error::Code::InvalidArgument,
            fmt::format("`tessellate` is not a whole number from 1 to {}", core::most_tessellated),
            "?tessellate=4 cuts each cell into 4 by 4 quads on a curved patch");
    return {};
}

/// The valid lines depend on the surface's kind, which is not known yet.
core::Result<void> read_lines_text(const std::string& text, DownloadRequest& out) {
    if (text.empty())
        return fail(Error::Code::InvalidArgument, "`lines` is empty", "as in ?lines=timelines:8");
    out.lines = text;
    return {};
}

} // namespace

core::Result<DownloadRequest> read_download(std::string_view file,
                                            const std::map<std::string, std::string>& query) {
    constexpr std::string_view stem = "mesh.";
    const auto format =
        file.starts_with(stem) ? protocol::mesh_format(file.substr(stem.size())) : std::nullopt;
    if (!format)
        return fail(Error::Code::NotFound, "there is no such file",
                    "ask for mesh" + protocol::mesh_extensions());
    DownloadRequest out;
    out.format = *format;
    for (const auto& [name, value] : query) {
        core::Result<void> read =
            name == "time"    ? read_time(value, out)
            : name == "draco" ? read_draco(value, out)
            : name == "now"   ? read_now(value, out)
            : name == "lines" ? read_lines_text(value, out)
            : name == "tessellate"
                ? read_tessellate(value, out)
                : fail(Error::Code::InvalidArgument,
                       "a download has no parameter `" + name.substr(0, 64) + "`",
                       "the parameters are ?time=2.5, ?time=end, ?draco=false, "
                       "?now=true, ?lines=timelines:8 and ?tessellate=4");
        if (!read)
            return tl::unexpected(read.error());
    }
    return out;
}

core::Result<ObstacleRequest> read_obstacle(const std::map<std::string, std::string>& query) {
    constexpr const char* usage = "?time=2.5 adds the velocity along it at that time, &field=p a "
                                  "field as well, patches=all all patches of the boundary, "
                                  "patch=NAME one; there is no other parameter";
    if (query.contains("patch") && query.contains("patches"))
        return fail(Error::Code::InvalidArgument, "`patch` and `patches` exclude each other",
                    "leave one out");
    ObstacleRequest asked;
    for (const auto& [name, value] : query) {
        if (name == "time")
            asked.time = finite_number(value);
        else if (name == "field")
            asked.field = value;
        else if (name == "patches")
            asked.patches.of = PatchChoice::Of::All;
        else if (name == "patch")
            asked.patches = {PatchChoice::Of::Named, {value}};
        else
            return fail(Error::Code::InvalidArgument,
                        "an obstacle has no parameter `" + name.substr(0, 64) + "`", usage);
        if (name == "time" && !asked.time)
            return fail(Error::Code::InvalidArgument, "`time` is not a finite number", usage);
        if (name == "patches" && value != "all")
            return fail(Error::Code::InvalidArgument, "`patches` can be `all` alone", usage);
    }
    if (!asked.field.empty() && !asked.time)
        return fail(Error::Code::InvalidArgument, "`field` needs a `time`", usage);
    return asked;
}

core::Result<std::optional<double>> shown_at(const DownloadRequest& request,
                                             const core::SurfaceParameters& p,
                                             std::optional<double> clock) {
    if (!core::moves(p) || request.at_the_end)
        return std::nullopt;
    const auto [first, last] = std::minmax({p.from, p.to});
    if (request.time && !core::within_rounding(*request.time, first, last))
        return fail(
            Error::Code::OutOfTime,
            fmt::format("time {} is outside of {} to {}, the times at which the surface is shown",
                        *request.time, first, last),
            "choose a `time` inside it, or `end`");
    const auto time = request.time ? request.time : clock;
    return time ? std::optional(p.from + core::time_sign(p) * core::age_at(p, time)) : std::nullopt;
}

} // namespace wakesurf::server
