#include "core/surface/surface_request.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wakesurf::core {

namespace {

/// Keeps the curves from the rake within four steps a quad allowed, about 800 bytes: a particle that circles for ever ends.
std::size_t steps_per_curve(const Rake& rake, double separation, std::uint64_t max_quads) {
    const double columns = std::max<double>(rake.seeds, SeedingCurve(rake).length() / separation);
    return static_cast<std::size_t>(
        std::clamp(4.0 * static_cast<double>(max_quads) / columns, 500.0, 50'000.0));
}

/// What the engine cannot compute. What users are told of it, by parameter, is in protocol/api.
Result<void> check_kind(const SurfaceParameters& p) {
    const auto refuse = [](const char* what, const char* hint) {
        return fail(Error::Code::InvalidArgument, what, hint);
    };
    if (p.release_until && p.kind != SurfaceKind::Streak)
        return refuse("'releaseUntil' is for streak surfaces", "leave it out");
    if (p.kind == SurfaceKind::Time && p.rake2.has_value() == p.sweep.has_value())
        return refuse("a time surface needs either a second rake or a sweep",
                      "give rake2 or sweep");
    if (p.kind != SurfaceKind::Time && (p.rake2 || p.sweep))
        return refuse("'rake2' and 'sweep' are for time surfaces", "leave them out");
    if (p.sweep && !(finite(*p.sweep) && glm::length(*p.sweep) > 0.0))
        return refuse("'sweep' must be a finite vector with a length", "give the patch a width");
    return {};
}

} // namespace

/// Error allowed per unit length: 1e-5 keeps a column of 16 lengths within 1e-3 of a default separation.
double trace_tolerance(Accuracy accuracy) {
    switch (accuracy) {
    case Accuracy::Fast:
        return 1e-4;
    case Accuracy::Balanced:
        return 1e-5;
    case Accuracy::Exact:
        break;
    }
    return 1e-9;
}

Result<void> check_times(const Flow& flow, const SurfaceParameters& p) {
    const auto range = flow.time_range();
    if (!range)
        return {};
    const auto inside = [&](const char* name, double time) -> Result<void> {
        if (within_rounding(time, (*range)[0], (*range)[1]))
            return {};
        const std::string range_text = time_text((*range)[0]) + " to " + time_text((*range)[1]);
        return fail(Error::Code::OutOfTime,
                    std::string(name) + " " + time_text(time) +
                        " is outside the times of the data, " + range_text,
                    "choose a time from " + range_text);
    };
    auto from = inside("'from'", p.from);
    return !from || p.kind == SurfaceKind::Stream ? from : inside("'to'", p.to);
}

Result<void> check_request(const SurfaceParameters& p) {
    if (auto sound = check_direction(p); !sound)
        return sound;
    if (!std::isfinite(p.separation) || p.separation < 0.0)
        return fail(Error::Code::InvalidArgument, "'separation' must be positive",
                    "leave it out for the dataset's finest spacing");
    if (!(p.merge >= 0.0 && p.merge <= 0.5))
        return fail(Error::Code::InvalidArgument, "'merge' must lie between 0 and 0.5",
                    "it is a fraction of the separation; 0 never merges");
    if (!(p.angle > 0.0 && p.angle <= 180.0))
        return fail(Error::Code::InvalidArgument, "'angle' must be above 0 and at most 180 degrees",
                    "leave it out for 20");
    if (!(p.stagnation_speed >= 0.0 && p.stagnation_speed <= 0.1))
        return fail(Error::Code::InvalidArgument, "'stagnationSpeed' must lie between 0 and 0.1",
                    "it is a part of the largest speed; leave it out for 1e-6");
    if (auto fits = check_kind(p); !fits)
        return fits;
    if (p.max_quads < 1)
        return fail(Error::Code::InvalidArgument, "'maxQuads' must be at least 1",
                    "leave it out for the default");
    return {};
}

Result<void> check_separation(const Flow& flow, double separation) {
    const double diagonal = glm::length(flow.domain().extent());
    const double least = 1e-6 * diagonal;
    const double most = 1e3 * diagonal;
    if (separation >= least && separation <= most)
        return {};
    std::ostringstream text;
    text << "'separation' is " << separation << "; in this domain it must lie between " << least
         << " and " << most;
    return fail(Error::Code::InvalidArgument, text.str(),
                "leave it out for the dataset's finest spacing");
}

Result<void> check_interpolation(const Flow& flow, Interpolation wanted) {
    if (wanted == Interpolation::Linear || flow.has_smooth())
        return {};
    return fail(Error::Code::InvalidArgument,
                flow.time_range() ? "`interpolation` cannot be smooth on this grid: only uniform "
                                    "grids have a smooth field"
                                  : "`interpolation` cannot be smooth here: a built-in flow is a "
                                    "formula, which is not interpolated",
                "leave `interpolation` out, or choose linear");
}

Result<double>
largest_speed(const Flow& flow, const Rake& rake, double time, std::stop_token stop) {
    std::vector<Vec3> points;
    const Box box = flow.domain();
    for (int i = 0; i < 343; ++i)
        points.push_back(box.lo + box.extent() * (Vec3(i % 7, i / 7 % 7, i / 49) / 6.0));
    const SeedingCurve seeding(rake);
    for (int i = 0; i <= 16; ++i)
        points.push_back(seeding.at(i / 16.0));
    const std::vector<double> times(points.size(), time);
    std::vector<Vec3> velocities(points.size());
    return flow.sample(points, times, velocities, stop).map([&] {
        double speed = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (flow.status(points[i]) == PointStatus::Inside)
                speed = std::max(speed, glm::length(velocities[i]));
        return speed;
    });
}

Result<std::vector<SheetOptions>> sheet_options(const Flow& flow,
                                                const Rake& rake,
                                                const SurfaceParameters& p,
                                                double separation,
                                                double largest_speed) {
    if (auto there = check_interpolation(flow, p.interpolation); !there)
        return tl::unexpected(there.error());
    SheetOptions one;
    one.trace.frozen = p.kind == SurfaceKind::Stream;
    one.trace.tolerance = trace_tolerance(p.accuracy);
    one.trace.smooth = p.interpolation == Interpolation::Smooth;
    one.trace.longest_step = flow.finest_spacing();
    one.trace.stagnation_speed = p.stagnation_speed * largest_speed;
    one.trace.most_steps = steps_per_curve(rake, separation, p.max_quads);
    one.trace.stretch = p.deformation;
    one.release = p.from;
    one.separation = separation;
    one.merge = p.merge;
    one.angle = p.angle;
    one.max_quads = p.max_quads;
    if (auto in_time = check_times(flow, p); !in_time)
        return tl::unexpected(in_time.error());
    const std::vector<double> durations = side_durations(flow, p);
    std::vector<SheetOptions> sheets;
    for (const double duration : durations) {
        one.duration = duration;
        sheets.push_back(one);
    }
    return sheets;
}

} // namespace wakesurf::core
