#include "protocol/files/surface_lines.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/files/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace wakesurf::protocol {

using core::Error;
using core::SurfaceKind;

namespace {

constexpr std::string_view timelines = "timelines";
constexpr std::string_view arrows_name = "arrows";
constexpr std::string_view points_name = "points";

/// Returns the name of lines of particles of one seed. Empty for time surfaces, each of whose points is a
/// particle of its own, and level surfaces.
std::string_view seed_lines(SurfaceKind kind) {
    switch (kind) {
    case SurfaceKind::Stream:
        return "streamlines";
    case SurfaceKind::Path:
        return "pathlines";
    case SurfaceKind::Streak:
        return "streaklines";
    case SurfaceKind::Time:
    case SurfaceKind::Level:
        break;
    }
    return {};
}

/// Returns the largest distance across the surface.
double widest(std::span<const double> parameter, std::span<const double> unit, bool wraps) {
    if (parameter.empty())
        return 0.0;
    const auto [low, high] = std::minmax_element(parameter.begin(), parameter.end());
    double longest = 0.0;
    for (const double length : unit)
        if (std::isfinite(length))
            longest = std::max(longest, length);
    return longest * (wraps ? 1.0 : *high - *low);
}

template <class Number>
bool read_number(std::string_view text, Number& out) {
    const auto read = std::from_chars(text.data(), text.data() + text.size(), out);
    return read.ec == std::errc{} && read.ptr == text.data() + text.size();
}

/// Reads `every=D,width=W` in either order, or N for the first of them. Returns false for any other text, and
/// for a value that is no length.
bool read_measures(std::string_view text, LinesWanted& out) {
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(','));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        const bool every = word.starts_with("every=");
        const bool width = word.starts_with("width=");
        if (every || width) {
            double& number = every ? out.spacing : out.width;
            if (number != 0.0 || !read_number(word.substr(6), number) || !std::isfinite(number) ||
                !(number > 0.0))
                return false;
        } else if (out.values != 0 || !read_number(word, out.values) || out.values == 0) {
            return false;
        }
    }
    return (out.values == 0) != (out.spacing == 0.0) &&
           (out.width > 0.0) == (out.form != LinesWanted::Form::Lines);
}

} // namespace

std::string_view parameter(const LinesWanted& wanted) {
    return wanted.along == LinesWanted::Along::Release ? "t" : "s";
}

core::Result<LinesWanted> read_lines(std::string_view text, SurfaceKind kind, MeshFormat format) {
    const std::string_view own = seed_lines(kind);
    const std::string kind_name(name(kind));
    const auto refuse = [](std::string what, std::string hint) {
        return core::fail(Error::Code::InvalidArgument, std::move(what), std::move(hint));
    };
    if (text == points_name && format == MeshFormat::Ply)
        return LinesWanted{.form = LinesWanted::Form::Points};
    if (text == points_name)
        return refuse("points cannot be written as ." + std::string(extension(format)),
                      "choose .ply");
    if (format == MeshFormat::Drc)
        return refuse("lines cannot be written as .drc", "choose .vtp, .glb, .ply or .obj");
    if (kind == SurfaceKind::Level)
        return refuse("a level surface has no lines: no particle runs along it",
                      "build a stream surface for its lines");
    const bool flows = kind == SurfaceKind::Stream || kind == SurfaceKind::Path;
    const std::string_view arrows_usage = "arrows:every=0.5,width=0.1";
    const std::string base(own.substr(0, own.size() - std::min<std::size_t>(own.size(), 5)));
    const std::string usage =
        own.empty() ? "all of it is one age; as in " + std::string(arrows_usage)
                    : "as in timelines:8, " + std::string(own) + ":every=0.5, " + base +
                          "ribbons:every=0.5,width=0.1 or " + std::string(arrows_usage);
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view which = text.substr(0, colon);
    LinesWanted out;
    out.seeds_flow = flows;
    const bool ribbons = !own.empty() && (which == "timeribbons" || which == base + "ribbons");
    if (which == arrows_name)
        out.form = LinesWanted::Form::Arrows;
    else if (ribbons)
        out.form = LinesWanted::Form::Ribbons;
    else if (own.empty() || (which != timelines && which != own))
        return refuse("a " + kind_name + " surface has no lines called '" +
                          std::string(which.substr(0, 64)) + "'",
                      usage);
    out.along = which.starts_with("time") ? LinesWanted::Along::Release : LinesWanted::Along::Seed;
    const std::string_view measures = text.substr(std::min(colon + 1, text.size()));
    const bool read = read_measures(measures, out);
    if (out.values > most_line_values || (!read && out.form == LinesWanted::Form::Lines &&
                                          measures.find('=') == std::string_view::npos))
        return refuse(
            "the number of lines is not between 1 and " + std::to_string(most_line_values), usage);
    if (!read || (out.form == LinesWanted::Form::Arrows && out.values > 0))
        return refuse("'" + std::string(measures.substr(0, 64)) + "' are not the measures of " +
                          std::string(which),
                      usage);
    if (out.spacing > 0.0 && out.width > out.spacing)
        return refuse("the width of " + std::string(which) +
                          " is larger than the distance between them",
                      usage);
    return out;
}

core::Result<SurfaceLines>
surface_lines(const core::QuadComplex& mesh, const LinesWanted& wanted, bool closed) {
    const bool release = wanted.along == LinesWanted::Along::Release;
    const auto& along = release ? mesh.t : mesh.s;
    const bool wraps = closed && !release;
    std::vector<double> unit;
    if (wanted.values == 0 || wanted.form != LinesWanted::Form::Lines)
        unit = core::lengths_per_unit(mesh, along, wraps);
    std::vector<core::EvenLevel> levels;
    if (wanted.values > 0) {
        for (const double value : core::evenly_spaced(along, wanted.values, wraps))
            levels.push_back({value, 0.0});
    } else {
        auto even = core::even_levels(mesh, along, unit, wanted.spacing, wraps, most_line_values);
        if (!even)
            return tl::unexpected(even.error());
        levels = *std::move(even);
    }
    SurfaceLines out;
    if (wanted.form == LinesWanted::Form::Ribbons) {
        if (const double across = widest(along, unit, wraps); wanted.width > across)
            return core::fail(Error::Code::InvalidArgument,
                              "the ribbons would be wider than the surface, which is " +
                                  number_text(across) + " across at most",
                              "give a smaller width");
        auto cut = core::ribbons(mesh, along, unit, levels, wanted.width, wraps);
        if (!cut)
            return tl::unexpected(cut.error());
        out.cutouts = *std::move(cut);
    } else if (wanted.values > 0) {
        std::vector<double> values;
        for (const core::EvenLevel& level : levels)
            values.push_back(level.value);
        out.lines = core::contour_lines(mesh, along, values, {wraps, {}});
    } else {
        out.lines = core::even_lines(mesh, along, unit, levels, wanted.spacing, wraps);
        if (wanted.form == LinesWanted::Form::Arrows) {
            auto cut = core::arrows(mesh, out.lines, wanted.spacing, wanted.width,
                                    {wanted.seeds_flow, wraps});
            if (!cut)
                return tl::unexpected(cut.error());
            out.cutouts = *std::move(cut);
        }
    }
    const bool lines = wanted.form == LinesWanted::Form::Lines;
    if (lines ? out.lines.empty() : out.cutouts.ends.empty())
        return core::fail(Error::Code::NotFound,
                          lines && wanted.values > 0
                              ? "there are no such lines: " + std::string(parameter(wanted)) +
                                    " is the same everywhere on this surface"
                              : "there is no room for them on this surface",
                          lines && wanted.values > 0 ? "" : "give smaller distances");
    return out;
}

} // namespace wakesurf::protocol
