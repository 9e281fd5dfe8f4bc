#include "core/surface/request/surface_plan.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/request/sheet_options.hpp"
#include "core/surface/request/surface_values.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace wakesurf::core {

namespace {

/// Keeps the curves from the rake within four steps a quad allowed, about 800 bytes: a particle that circles
/// for ever ends.
std::size_t
steps_per_curve(const Rake& rake, double length, double separation, std::uint64_t max_quads) {
    const double columns = std::max<double>(rake.seeds, length / separation);
    return static_cast<std::size_t>(
        std::clamp(4.0 * static_cast<double>(max_quads) / columns, 500.0, 50'000.0));
}

/// All but the `to` of a stream surface lie in the times of the data.
Result<void> check_times(const Flow& flow, const SurfaceParameters& p) {
    const auto range = flow.time_bounds();
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
    auto from = inside("`from`", p.from);
    return !from || p.kind == SurfaceKind::Stream ? from : inside("`to`", p.to);
}

/// Cells of that edge can show something of the flow.
Result<void> check_separation(const Flow& flow, double separation) {
    const double diagonal = glm::length(flow.domain().extent());
    const double least = 1e-6 * diagonal;
    const double most = 1e3 * diagonal;
    if (separation >= least && separation <= most)
        return {};
    std::ostringstream text;
    text << "`separation` is " << separation << "; in this domain it must lie between " << least
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

Result<void> check_between(const Flow& flow, const SurfaceParameters& p) {
    if (p.between == Between::Linear)
        return {};
    if (!flow.time_range())
        return fail(Error::Code::InvalidArgument,
                    "`between` cannot be other than linear here: a built-in flow is a formula, "
                    "which is known at all times",
                    "leave `between` out, or choose linear");
    if (p.interpolation == Interpolation::Smooth)
        return fail(Error::Code::InvalidArgument,
                    "`between` goes with `interpolation` linear: smooth is cubic in time already",
                    "leave out the one or the other");
    return {};
}

/// Takes the part inside the domain.
Result<void> clip(Rake& rake, const Box& domain, bool& clipped) {
    return clip_rake(rake, domain).map([&](ClippedRake&& kept) {
        rake = std::move(kept.rake);
        clipped = clipped || kept.clipped;
    });
}

/// A level surface begins at no rake, and so one that lies anywhere will do.
Result<void> clip_rakes(SurfacePlan& plan) {
    if (plan.parameters.kind == SurfaceKind::Level)
        return {};
    const Box domain = plan.flow->domain();
    if (auto inside = clip(plan.rake, domain, plan.clipped); !inside)
        return inside;
    auto& second = plan.parameters.rake2;
    if (!second)
        return {};
    return clip(*second, domain, plan.clipped).map_error([](Error error) {
        error.message = "`rake2`: " + error.message;
        return error;
    });
}

} // namespace

/// Returns the error allowed per unit length: 1e-5 keeps a column of 16 lengths within 1e-3 of a default
/// separation.
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

Result<SurfacePlan>
plan_surface(std::shared_ptr<const Flow> flow, const Rake& rake, SurfaceParameters parameters) {
    SurfacePlan plan{std::move(flow), rake, std::move(parameters), {}, {}, false};
    SurfaceParameters& p = plan.parameters;
    if (p.separation == 0.0)
        p.separation = plan.flow->finest_spacing();
    if (const auto range = plan.flow->time_range();
        p.kind == SurfaceKind::Level && range && (*range)[0] == (*range)[1])
        p.from = p.to = (*range)[0]; // the field is the same at all times
    auto sound = check_values(p)
                     .and_then([&] { return check_direction(p); })
                     .and_then([&] { return check_interpolation(*plan.flow, p.interpolation); })
                     .and_then([&] { return check_between(*plan.flow, p); })
                     .and_then([&] { return check_separation(*plan.flow, p.separation); })
                     .and_then([&] { return clip_rakes(plan); })
                     .and_then([&] { return check_times(*plan.flow, p); });
    if (!sound)
        return tl::unexpected(std::move(sound.error()));
    p.direction = direction_of(p);
    if (p.between != Between::Linear)
        plan.flow = plan.flow->interpolated(p.between);
    if (p.kind != SurfaceKind::Level)
        plan.seeding = SeedingCurve(plan.rake);
    return plan;
}

Result<SurfacePlan>
plan_surface(const Flow& flow, const Rake& rake, const SurfaceParameters& parameters) {
    return plan_surface(std::shared_ptr<const Flow>(std::shared_ptr<void>{}, &flow), rake,
                        parameters);
}

Result<double> SurfacePlan::largest_speed(std::stop_token stop) const {
    std::vector<Vec3> points;
    const Box box = flow->domain();
    // Samples few places, none on the domain's faces: in a time-step that is read by brick each is a brick of
    // its own. With 7^3 they were 355 bricks, 155 MB, and most of the time to a first surface over HTTP.
    for (int i = 0; i < 27; ++i)
        points.push_back(box.lo +
                         box.extent() *
                             (Vec3(1 + 2 * (i % 3), 1 + 2 * (i / 3 % 3), 1 + 2 * (i / 9)) / 6.0));
    for (int i = 0; i <= 16; ++i)
        points.push_back(seeding.at(i / 16.0));
    std::vector<Vec3> velocities(points.size());
    const auto speed_at = [&](double time) {
        const std::vector<double> times(points.size(), time);
        return flow->sample(points, times, velocities, stop).map([&] {
            double speed = 0.0;
            for (std::size_t i = 0; i < points.size(); ++i)
                if (flow->status(points[i]) == PointStatus::Inside)
                    speed = std::max(speed, glm::length(velocities[i]));
            return speed;
        });
    };
    auto speed = speed_at(parameters.from);
    if (parameters.kind == SurfaceKind::Stream)
        return speed;
    // A flow that starts from rest: each later time may be a time-step to read.
    for (const double part : {1.0, 0.5, 0.25, 0.75})
        if (speed && *speed == 0.0)
            speed = speed_at(parameters.from + part * (parameters.to - parameters.from));
    return speed;
}

std::vector<SheetOptions> SurfacePlan::sheets(double separation, double largest_speed) const {
    const SurfaceParameters& p = parameters;
    SheetOptions one;
    one.trace.frozen = p.kind == SurfaceKind::Stream;
    one.trace.tolerance = trace_tolerance(p.accuracy);
    one.trace.smooth = p.interpolation == Interpolation::Smooth;
    one.trace.longest_step = flow->finest_spacing();
    one.trace.stagnation_speed = p.stagnation_speed * largest_speed;
    one.trace.most_steps = steps_per_curve(rake, seeding.length(), separation, p.max_quads);
    // With the stretch it is known where the sheet twists.
    one.trace.stretch = p.deformation || p.tangents || p.angle < 180.0;
    one.release = p.from;
    one.separation = separation;
    one.merge = p.merge;
    one.angle = p.angle;
    one.max_quads = p.max_quads;
    std::vector<SheetOptions> sheets;
    for (const double duration : side_durations(*flow, p)) {
        one.duration = duration;
        sheets.push_back(one);
    }
    return sheets;
}

} // namespace wakesurf::core
