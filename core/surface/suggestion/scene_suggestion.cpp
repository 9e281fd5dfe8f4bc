#include "core/surface/suggestion/scene_suggestion.hpp"

#include "core/surface/suggestion/rake_choice.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr std::uint32_t usual_seeds = 32;
/// The flow is slower in a wake than ahead of it: the time for a way is this much longer than the fastest
/// needs.
constexpr double slower = 1.25;
/// A part of that time, for a time surface.
constexpr double patch_part = 0.35;
/// Limits the bytes of time-steps that a first surface reads, unless those are fewer than `least_steps`.
constexpr double most_bytes = 4.0 * (1ULL << 30U);
constexpr std::size_t least_steps = 8;
// Limit what a surface costs: how often a vertex is moved, in all, and how many quads are enough to see, and
// too few.
constexpr double most_moves = 4e6, most_quads = 20'000.0, least_quads = 2'000.0;
// The cells across the body, at least, and along the rake, at most.
constexpr double across_body = 6.0, along_rake = 40.0, along_rake_in_vortex = 24.0;

// What moves is shown first only where it is no scrap, and soon there: data that last so long, as a share of the time to cross
// the view, and bytes of time-steps. Flow that goes round and round winds streak surfaces up: a first one of flow:tornado takes
// 26 s of a processor, a stream surface 0.2 s.
constexpr double least_lasting = 0.3, soon_read = 1.0 * (1ULL << 30U);

/// Behind a body in steady flow nothing new comes after so many of its sizes.
constexpr double steady_wake = 5.0;

/// Returns how far to follow the particles.
double way_of(const RakeChoice& choice, const FlowSurvey& survey, bool steady) {
    if (!steady || !choice.body || !survey.through())
        return choice.way;
    const int axis = survey.axis();
    const Vec3 extent = choice.body->extent();
    const double behind = survey.sign() > 0.0 ? choice.body->hi[axis] : choice.body->lo[axis];
    const double rake = 0.5 * (choice.line[0][axis] + choice.line[1][axis]);
    return std::min(choice.way, std::abs(behind - rake) +
                                    steady_wake * std::max({extent.x, extent.y, extent.z}));
}

/// Rounds to so many digits.
double rounded(double value, int digits) {
    if (!(value > 0.0) || !std::isfinite(value))
        return value;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
    return std::round(value / unit) * unit;
}

Vec3 rounded(const Vec3& place, const Box& domain) {
    const Vec3 extent = domain.extent();
    Vec3 out = place;
    for (int k = 0; k < 3; ++k) {
        if (!(extent[k] > 0.0))
            continue;
        const double digits = 3.0 - std::floor(std::log10(extent[k]));
        const double unit = std::pow(10.0, std::abs(digits));
        // The value is divided by a power of ten, not multiplied by its inverse: what is printed in few
        // digits reads the same.
        const double near =
            digits > 0.0 ? std::round(place[k] * unit) / unit : std::round(place[k] / unit) * unit;
        out[k] = std::clamp(near, domain.lo[k], domain.hi[k]);
    }
    return out;
}

/// Returns the time for the particles to cross the view; the default if nothing moves.
double usual_time(const RakeChoice& choice) {
    return choice.speed > 0.0 ? rounded(slower * choice.way / choice.speed, 2) : 1.0;
}

/// The last time-steps that last so long, as far as there are so many and they are not too large; where they are much
/// farther apart, the last of the time between them.
double first_time(const SeriesFacts& series, double wanted) {
    const auto& times = series.times;
    std::size_t first = times.size() - 1;
    const double bytes = static_cast<double>(series.bytes_per_step);
    while (first > 0 && times.back() - times[first] < wanted * (1.0 - 1e-9)) {
        const std::size_t steps = times.size() - first + 1;
        if (steps > least_steps && static_cast<double>(steps) * bytes > most_bytes)
            break;
        --first;
    }
    return std::max(times[first], times.back() - 1.5 * wanted);
}

double separation_of(const Flow& flow, const RakeChoice& choice, double time) {
    const double finest = flow.finest_spacing();
    const double width = glm::length(choice.line[1] - choice.line[0]);
    const double way = std::min(choice.way, choice.speed * time);
    const double area = width * std::max(way, width / 4.0);
    const double moves = std::max(1.0, way / (0.5 * finest));
    const double quads = std::clamp(most_moves / moves, least_quads, most_quads);
    double separation = std::sqrt(area / quads);
    // Where the flow turns, surfaces become much longer than the way.
    separation = std::max(separation, width / (choice.body ? along_rake : along_rake_in_vortex));
    if (choice.body) {
        const Vec3 extent = choice.body->extent();
        std::array<double, 3> sides{extent.x, extent.y, extent.z};
        std::ranges::sort(sides);
        separation = std::min(separation, sides[1] / across_body);
    }
    return separation <= finest ? finest : rounded(separation, 2);
}

SurfaceParameters
surface_of(SurfaceKind kind, double from, double to, double separation, const Vec3& sweep) {
    SurfaceParameters p;
    p.kind = kind;
    p.from = from;
    p.to = to;
    p.separation = separation;
    if (kind == SurfaceKind::Time)
        p.sweep = sweep;
    return p;
}

/// Makes a line a ring round the axis, at about the same place along it: half of what flows there does so inside.
Result<void> make_ring(RakeChoice& choice,
                       Rake& rake,
                       const SymmetryAxis& axis,
                       const Flow& flow,
                       double time,
                       std::stop_token stop) {
    constexpr int places = 64;
    const Box domain = flow.domain();
    const Vec3 from = 0.5 * (choice.line[0] + choice.line[1]) - axis.origin;
    const Vec3 centre = axis.origin + glm::dot(from, axis.direction) * axis.direction;
    const Vec3 outward = glm::cross(axis.direction, axis.radial);
    double most = 0.0;
    for (int k = 0; k < 3; ++k)
        most = std::max(most, std::abs(outward[k]) * (domain.hi[k] - centre[k]));
    std::vector<Vec3> points;
    for (int i = 0; i < places; ++i)
        if (const Vec3 p = centre + most * (i + 0.5) / places * outward;
            flow.status(p) == PointStatus::Inside)
            points.push_back(p);
    std::vector<Vec3> velocity(points.size());
    const std::vector<double> times(points.size(), time);
    if (auto sampled = flow.sample(points, times, velocity, std::move(stop)); !sampled)
        return sampled;
    double all = 0.0;
    for (const Vec3& v : velocity)
        all += glm::length(v);
    double inside = 0.0;
    std::size_t at = points.size() / 2;
    for (std::size_t i = 0; i < points.size() && all > 0.0; ++i) {
        inside += glm::length(velocity[i]);
        if (inside >= 0.5 * all) {
            at = i;
            break;
        }
    }
    if (points.empty())
        return {}; // the line was found in fluid; a ring there would not be
    const double radius = glm::length(points[at] - centre);
    rake.kind = Rake::Kind::Circle;
    rake.points = {centre, centre + radius * axis.radial, centre + radius * outward};
    choice.line = {centre - radius * outward, centre + radius * outward};
    const double along = glm::dot(domain.extent(), glm::abs(axis.direction));
    choice.sweep = 0.1 * along * axis.direction;
    return {};
}

double bytes_between(const SeriesFacts& series, double from, double to) {
    const auto inside =
        std::ranges::count_if(series.times, [&](double t) { return t >= from && t <= to; });
    return static_cast<double>(inside) * static_cast<double>(series.bytes_per_step);
}

bool at_rest(const FlowSurvey& survey) {
    return !(survey.speed > 0.0);
}

} // namespace

Result<SceneSuggestion> suggest_scene(const Flow& flow,
                                      const SeriesFacts& series,
                                      const WallGeometry& walls,
                                      std::stop_token stop) {
    const std::vector<double>& times = series.times;
    double shown = times.back();
    auto survey = survey_flow(flow, shown, stop);
    for (const std::size_t quarter : {2U, 3U, 1U})
        if (survey && at_rest(*survey) && times.size() > 1) {
            shown = times[times.size() * quarter / 4];
            survey = survey_flow(flow, shown, stop);
        }
    if (!survey)
        return tl::unexpected(survey.error());
    if (at_rest(*survey))
        shown = times.back(); // and at all others: of no time is more to see
    const bool moves = series.steady || times.size() > 1;
    const std::optional<double> available =
        series.steady || times.size() < 2 ? std::nullopt : std::optional(shown - times.front());
    RakeChoice choice = choose_rake(flow, *survey, walls, available);
    choice.way = way_of(choice, *survey, series.steady);
    SceneSuggestion out;
    const Box domain = flow.domain();
    out.rake = {Rake::Kind::Line,
                {rounded(choice.line[0], domain), rounded(choice.line[1], domain)},
                usual_seeds};
    out.why = "The rake is " + choice.why + ".";
    if (series.axis) {
        if (auto ring = make_ring(choice, out.rake, *series.axis, flow, shown, stop); !ring)
            return tl::unexpected(ring.error());
        out.why = "The rake is a ring round the axis, half-way through what flows there.";
    }
    // Never so short that two times are one number, however fast a simulation that diverged is.
    const double least = 1e-9 * std::max(std::abs(shown), times.back() - times.front());
    const double long_enough = std::max(usual_time(choice), least);
    const Vec3 sweep = choice.sweep;
    out.surfaces.push_back(surface_of(SurfaceKind::Stream, shown, shown + long_enough,
                                      separation_of(flow, choice, long_enough), sweep));
    if (!moves)
        return out;
    SeriesFacts until_shown = series;
    std::erase_if(until_shown.times, [&](double time) { return time > shown; });
    const double from = series.steady ? shown : first_time(until_shown, long_enough);
    const double to = series.steady ? shown + long_enough : shown;
    const double separation = separation_of(flow, choice, to - from);
    for (const auto kind : {SurfaceKind::Path, SurfaceKind::Streak})
        out.surfaces.push_back(surface_of(kind, from, to, separation, sweep));
    // All of a time surface is where its particles are in the end: not gone yet.
    const double part = long_enough * patch_part;
    out.surfaces.push_back(surface_of(SurfaceKind::Time,
                                      series.steady ? from : first_time(until_shown, part),
                                      series.steady ? from + part : to, separation, sweep));
    if (survey->through() && !series.steady && to - from >= least_lasting * long_enough &&
        bytes_between(series, from, to) <= soon_read) {
        const auto streak =
            std::ranges::find(out.surfaces, SurfaceKind::Streak, &SurfaceParameters::kind);
        std::rotate(out.surfaces.begin(), streak, std::next(streak));
    }
    return out;
}

} // namespace wakesurf::core
