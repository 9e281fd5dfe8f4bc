#include "core/surface/moving/moving_plan.hpp"

#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wakesurf::core {

namespace {

constexpr double joined_at_most = 11.0 / 7.0; ///< of `merge`: the longest edge that is joined
constexpr double most_rows = 20'000;          ///< that a surface takes to its end

Origin origin_of(const SurfacePlan& plan) {
    const SurfaceParameters& p = plan.parameters;
    if (p.kind == SurfaceKind::Streak)
        return Origin(plan.seeding, p.interpolation == Interpolation::Smooth);
    return p.rake2 ? Origin(plan.seeding, SeedingCurve(*p.rake2), p.from)
                   : Origin(plan.seeding, *p.sweep, p.from);
}

} // namespace

MovingRequest::MovingRequest(SurfacePlan asked, double fastest)
    : plan(std::move(asked)), largest_speed(fastest), origin(origin_of(plan)) {}

double MovingRequest::travel() const {
    return largest_speed * time_span(plan.parameters);
}

MovingPlan make_plan(const MovingRequest& request, double separation) {
    const Flow& flow = *request.plan.flow;
    const SurfaceParameters& p = request.plan.parameters;
    const Origin& origin = request.origin;
    const double span = time_span(p);
    Columns columns = make_columns(origin, seeds_at(request, separation));
    RefinementRules rules;
    rules.separation = separation;
    rules.coarsest = std::max(separation, coarsest_separation(flow.domain()));
    rules.merge = joined_at_most * p.merge;
    rules.cosine = p.angle >= 180.0 ? -1.0 : std::cos(p.angle * std::numbers::pi / 180.0);
    // Neighbours that are apart by mistake are cut as if the flow had parted them: with ten times the
    // tolerance a fast surface of sqcyl-foam had 54,506 quads for 39,029, and took longer.
    const double tolerance =
        trace_tolerance(p.accuracy == Accuracy::Fast ? Accuracy::Balanced : p.accuracy);
    // Where the flow parts seeds that are closer than particles are followed, cuts find the errors: with a
    // millionth here a balanced time surface behind a sphere had 92,413 quads, an exact one 63,293, and with
    // this 65,125.
    rules.least_s = std::max(1e-6, tolerance);
    rules.least_t = rules.least_s * (origin.patch() ? 1.0 : span);
    // Seeds this close that still part beside an obstacle go round it on either side.
    const double seed_distance = separation / 32.0;
    rules.least_s_at_wall = seed_distance / origin.length();
    rules.least_t_at_wall =
        seed_distance /
        (origin.patch() ? origin.longest_across() : std::max(request.largest_speed, 1e-300));
    rules.policy =
        p.accuracy == Accuracy::Exact ? InsertionPolicy::Exact : InsertionPolicy::Hermite;
    rules.retrace = p.accuracy == Accuracy::Exact || flow.few_data(p.from, p.to);
    // Cuts below this showed the errors of fast surfaces, not their shape: 1.4 times the quads of balanced
    // ones.
    if (p.accuracy == Accuracy::Fast) {
        rules.finest = 0.25;
        rules.trusted_error = 0.2;
    }
    rules.obstacle = flow.obstacle();
    rules.max_quads = p.max_quads;
    // RK4 in steps of a part of a cell is several times faster in batches, on grids. Its errors are tested
    // (step_errors.hpp), and vertices with too large a one are traced again.
    const bool batches = p.accuracy != Accuracy::Exact && flow.steps_in_batches();
    AdvanceOptions carry;
    carry.method = batches ? AdvanceOptions::Method::Rk4 : AdvanceOptions::Method::Dopri5;
    carry.tolerance = tolerance;
    carry.longest_step = flow.finest_spacing();
    carry.stagnation_speed = p.stagnation_speed * request.largest_speed;
    carry.smooth = p.interpolation == Interpolation::Smooth;
    std::vector<double> seeds = row_seeds(
        origin, flow, columns,
        p.refine == Refine::On ? rules.tear_size * separation : std::numeric_limits<double>::max());
    return {request,
            std::move(columns),
            std::move(seeds),
            rules,
            carry,
            p.to,
            p.release_until.value_or(p.to),
            p.accuracy == Accuracy::Fast,
            flow.finest_spacing(),
            true,
            {}};
}

double least_separation(const MovingRequest& request) {
    return std::max(request.plan.parameters.separation,
                    request.travel() / (row_spacing * most_rows));
}

double seeds_at(const MovingRequest& request, double separation) {
    const SurfaceParameters& p = request.plan.parameters;
    const auto intervals = p.refine == Refine::On ? seed_intervals : grid_intervals;
    return intervals(request.plan.rake, request.origin.length(), separation, p.separation);
}

BudgetSearch budget_search(const MovingRequest& request) {
    const SurfaceParameters& p = request.plan.parameters;
    const Box domain = request.plan.flow->domain();
    const Origin& origin = request.origin;
    const double across = origin.patch() ? origin.longest_across()
                                         : std::min(request.travel(), glm::length(domain.extent()));
    const double separation = least_separation(request);
    const double wide = p.refine == Refine::On ? std::max(1.0, origin.length() / separation)
                                               : seeds_at(request, separation);
    const double unstretched = wide * std::max(1.0, across / separation);
    return {separation, coarsest_separation(domain), unstretched, p.max_quads};
}

} // namespace wakesurf::core
