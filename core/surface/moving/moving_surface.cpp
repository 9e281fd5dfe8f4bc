#include "core/surface/moving/moving_surface.hpp"

#include "core/base/for_each_index.hpp"
#include "core/integrate/advance_particle.hpp"
#include "core/surface/budget_search.hpp"
#include "core/surface/moving/refinement.hpp"
#include "core/surface/moving/release.hpp"
#include "core/surface/moving/snapshot.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

namespace wakesurf::core {

namespace {

/// The rows of a patch are so far apart, in separations. With 1 an edge between rows that lean by anything at
/// all would be too long, and columns that come together could not be joined.
constexpr double patch_spacing = 0.9;

constexpr double patch_bytes = 350.0; ///< a quad, while it is laid

/// Surfaces that were begun and exceeded their budget, after which the next one is made coarser as it moves.
constexpr int most_given_up = 3;

/// The integrator's errors are measured every so many steps.
constexpr std::uint64_t check_every = 4;

// Limit steps in flows that start from rest: how much faster than now the fluid may become within one, at how many
// places that is looked at, and the part of a separation that it goes within a stored interval while it is as good
// as at rest. Flows that change slowly take the steps that they would have without.
constexpr double speeding_up = 2.0;
constexpr std::size_t most_sampled = 256;
constexpr double as_good_as_rest = 1e-3;

constexpr double carry_share = 0.4;     // of a step, in the reported progress
constexpr double sorting_share = 0.125; // of vertices inserted since memory was last in mesh order

/// Ends the particles that are older than they may become, at the time at which they did. They have been
/// carried on to the mesh's time, so that the surface can be cut where it is just that old (clipping.cpp).
void end_the_old(MovingMesh& mesh, const SurfaceParameters& p) {
    if (!p.life)
        return;
    MaterialVertices& v = mesh.vertices;
    for_each_index(v.slots(), [&](std::size_t i) {
        const double release = p.kind == SurfaceKind::Time ? p.from : v.t[i];
        if (!v.running(static_cast<VertexId>(i)) ||
            !(std::abs(mesh.time - release) > *p.life * (1.0 + 1e-12)))
            return;
        v.end[i] = CurveEnd::Time;
        v.time[i] = release + time_sign(p) * *p.life;
    });
}

double elapsed(const Clock& clock, std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(clock.now() - since).count();
}

} // namespace

MovingSurface::MovingSurface(MovingPlan plan, const Clock& clock)
    : flow_(plan.request.plan.flow.get()), clock_(&clock) {
    state_.plan = std::make_shared<const MovingPlan>(std::move(plan));
    state_.separation = state_.plan->rules.separation;
    state_.mesh.time = state_.plan->request.plan.parameters.from;
    state_.errors_until = state_.mesh.time;
    if (state_.plan->estimates)
        state_.step_errors = StepErrors(flow_->domain());
}

Result<MovingSurface> MovingSurface::start(const SurfacePlan& asked,
                                           std::stop_token stop,
                                           const Clock& clock,
                                           const WorkPart& work) {
    const auto began = clock.now();
    const auto speed = asked.largest_speed(stop);
    if (!speed)
        return tl::unexpected(speed.error());
    const double load = elapsed(clock, began);
    const MovingRequest request(asked, *speed);
    auto plan = plan_within_budget(request, budget_search(request), stop, clock, work);
    if (!plan)
        return tl::unexpected(plan.error());
    MovingSurface surface(std::move(*plan), clock);
    if (auto begun = surface.begin_within_budget(stop, work); !begun)
        return tl::unexpected(begun.error());
    surface.seconds_.load = load;
    surface.seconds_.refine = elapsed(clock, began) - load;
    return surface;
}

/// The most quads that a surface has until its end. Nothing: more than its rules allow.
Result<std::optional<std::uint64_t>> MovingSurface::most_quads(MovingPlan plan,
                                                               const Clock& clock,
                                                               const std::stop_token& stop,
                                                               const WorkPart& work) {
    MovingSurface surface(std::move(plan), clock);
    const double from = surface.time();
    auto within = surface.begin(stop, work.quietly());
    std::uint64_t most = 0;
    for (;;) {
        if (!within && within.error().readable_until && most > 0)
            return most; // of the time-steps that can be read
        if (!within)
            return tl::unexpected(within.error());
        if (!*within)
            return std::nullopt;
        most = std::max<std::uint64_t>(most, surface.state_.mesh.triangles.quads());
        if (surface.time() == surface.end_time())
            return most;
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        within = surface.move(surface.next_time(surface.end_time(), stop), stop, work.quietly());
        work.reached(std::abs(surface.time() - from) / std::abs(surface.end_time() - from));
    }
}

/// The next plan whose surface should keep its quad budget to its end, as far as coarser surfaces can tell.
Result<MovingPlan> MovingSurface::plan_within_budget(const MovingRequest& request,
                                                     BudgetSearch search,
                                                     const std::stop_token& stop,
                                                     const Clock& clock,
                                                     const WorkPart& work) {
    while (const auto trial = search.next()) {
        if (seeds_at(request, trial->separation) > static_cast<double>(trial->most)) {
            search.exceeded();
            continue;
        }
        MovingPlan plan = make_plan(request, trial->separation);
        const bool asked_for = trial->separation == least_separation(request);
        if (!asked_for && !search.near()) {
            plan.rules.max_quads = trial->most;
            plan.rules.coarsens = false;
            const auto quads = most_quads(plan, clock, stop, work.rest().between(0.0, trial_share));
            if (!quads)
                return tl::unexpected(quads.error());
            if (!*quads)
                search.exceeded();
            if (!*quads || !search.built(**quads))
                continue;
            plan.rules.max_quads = request.plan.parameters.max_quads;
        }
        plan.rules.coarsens = search.given_up() >= most_given_up;
        plan.search = search;
        return plan;
    }
    return cannot_be_coarser(request.plan.parameters.max_quads, search.coarsest());
}

/// Makes the surface at its start. Returns false if it has more quads than its rules allow.
Result<bool> MovingSurface::begin(const std::stop_token& stop, const WorkPart& work) {
    const MovingPlan& plan = *state_.plan;
    MovingMesh& mesh = state_.mesh;
    const bool patch = plan.request.origin.patch();
    mesh.rectangle = {plan.columns.closed, patch, patch ? 0.0 : mesh.time,
                      patch ? 1.0 : -time_sign(plan.request.plan.parameters)};
    if (!refines())
        mesh.triangles.allow_contacts();
    if (patch) {
        const double rows = std::max(1.0, std::ceil(plan.request.origin.longest_across() /
                                                        (patch_spacing * state_.separation) -
                                                    1e-9));
        const double quads = plan.columns.count * rows;
        if (quads > static_cast<double>(plan.rules.max_quads))
            return false;
        if (auto room = work.holds(static_cast<std::size_t>(patch_bytes * quads)); !room)
            return tl::unexpected(room.error());
        if (auto laid = lay_patch(mesh, plan.request.origin, *flow_, plan.columns, rows, stop);
            !laid)
            return tl::unexpected(laid.error());
        if (const auto within = refine(mesh.time, plan.carry, stop, work); !within || !*within)
            return within;
    } else {
        if (auto row = attach_row(mesh, plan.request.origin, *flow_, plan.seeds, stop); !row)
            return tl::unexpected(row.error());
        for (VertexId v = 0; v < mesh.vertices.slots(); ++v)
            state_.terminated.obstacle += mesh.vertices.end[v] == CurveEnd::Obstacle;
        state_.releasing = true;
    }
    if (auto sampled = sample_velocity(stop); !sampled)
        return tl::unexpected(sampled.error());
    return true;
}

Result<void> MovingSurface::begin_within_budget(const std::stop_token& stop, const WorkPart& work) {
    const auto within = begin(stop, work);
    if (!within)
        return tl::unexpected(within.error());
    return *within ? Result<void>{} : start_coarser(time(), stop, work);
}

/// Starts again at a separation that keeps the budget, and carries the surface to `until`. New ids: none
/// stands for two vertices.
Result<void>
MovingSurface::start_coarser(double until, const std::stop_token& stop, const WorkPart& work) {
    const MovingRequest request = state_.plan->request;
    BudgetSearch search = *state_.plan->search;
    search.exceeded();
    if (state_.plan->rules.coarsens) // and could not be made coarser as it moved
        search.settle();
    const std::uint32_t vertex_id = state_.mesh.vertices.next_id();
    const std::uint32_t cell_id = state_.mesh.triangles.next_id();
    state_.mesh = {};
    auto plan = plan_within_budget(request, search, stop, *clock_, work);
    if (!plan)
        return tl::unexpected(plan.error());
    MovingSurface coarser(std::move(*plan), *clock_);
    state_ = std::move(coarser.state_);
    state_.mesh.vertices.number_from(vertex_id);
    state_.mesh.triangles.number_from(cell_id);
    if (auto begun = begin_within_budget(stop, work); !begun)
        return begun;
    return advance_to(until, stop, work);
}

/// Refines the mesh. Returns false if it has more quads than its rules allow.
Result<bool> MovingSurface::refine(double before,
                                   const AdvanceOptions& carry,
                                   const std::stop_token& stop,
                                   const WorkPart& work) {
    if (!refines()) {
        leave_out_dead(state_.mesh);
        if (auto room = work.holds(memory_while_moving(state_.mesh)); !room)
            return tl::unexpected(room.error());
        return state_.mesh.triangles.quads() <= state_.plan->rules.max_quads;
    }
    RefinementRules rules = state_.plan->rules;
    rules.separation = state_.separation;
    Refinement refinement(*flow_, state_.plan->request.origin, rules, before, state_.steps, carry,
                          refinement_memory_);
    const auto within = refinement.run(state_.mesh, stop, work);
    state_.separation = refinement.rules().separation;
    state_.torn += refinement.unresolved();
    if (stop.stop_requested()) // the budget was then exceeded too, or not checked
        return fail(Error::Code::Cancelled, "the surface was cancelled");
    return within;
}

bool MovingSurface::refines() const {
    return state_.plan->request.plan.parameters.refine == Refine::On;
}

/// Samples the velocity at every vertex now; the rake's particles leave along it.
Result<void> MovingSurface::sample_velocity(const std::stop_token& stop) {
    MaterialVertices& v = state_.mesh.vertices;
    const bool smooth = state_.plan->carry.smooth;
    if (auto sampled =
            flow_->sample_at(v.position, state_.mesh.time, v.velocity, stop, smooth, v.cell);
        !sampled)
        return sampled;
    const std::vector<VertexId> row = attached(state_.mesh);
    std::vector<Vec3> places, leaving(row.size());
    for (const VertexId i : row)
        places.push_back(v.position[i]);
    const std::vector<double> now(row.size(), state_.mesh.time);
    if (auto sampled = flow_->sample(places, now, leaving, stop, smooth); !sampled)
        return sampled;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const VertexId i = row[k];
        v.along_t[i] = -leaving[k];
        v.birth_area[i] = static_cast<float>(glm::length(glm::cross(v.along_s[i], v.along_t[i])));
    }
    return {};
}

double MovingSurface::next_time(double to, const std::stop_token& stop) const {
    const double here = state_.mesh.time;
    const double sign = to < here ? -1.0 : 1.0;
    const double until = state_.plan->release_until;
    const double target =
        state_.releasing && sign * (until - here) > 0.0 && sign * (to - until) > 0.0 ? until : to;
    double dt = step_length(state_.mesh, target, state_.separation, state_.releasing, refines());
    // Fluid at rest says nothing of how long a step may be: what it does within a stored interval is known. Nothing
    // later is looked at, which would have to be read.
    const auto stored = flow_->next_stored_time(here, sign);
    if (const double interval = stored ? std::abs(*stored - here) : dt; interval < dt) {
        const double speed = leading_speed(here, stop);
        if (speed * interval >= as_good_as_rest * state_.separation &&
            leading_speed(*stored, stop) <= speeding_up * speed)
            return dt == std::abs(target - here) ? target : here + sign * dt;
        dt = interval;
    }
    for (int i = 0; i < 40; ++i, dt *= 0.5)
        if (leading_speed(here + sign * dt, stop) * dt <=
            speeding_up * row_spacing * state_.separation)
            break;
    return dt == std::abs(target - here) ? target : here + sign * dt;
}

/// The speed of what decides how long a step may be, where it is now but at another time: of the fastest on the
/// rake while that releases particles, or of some of the others. 0 where the data cannot be had: the step will say
/// so.
double MovingSurface::leading_speed(double time, const std::stop_token& stop) const {
    const MaterialVertices& v = state_.mesh.vertices;
    const auto fastest = [&](VertexRole role, std::size_t stride) {
        std::vector<Vec3> places;
        for (std::size_t i = 0; i < v.slots(); i += stride)
            if (v.role[i] == role && v.end[i] == CurveEnd::Running)
                places.push_back(v.position[i]);
        std::vector<Vec3> velocity(places.size());
        const std::vector<double> times(places.size(), time);
        double speed = 0.0;
        if (flow_->sample(places, times, velocity, stop, state_.plan->carry.smooth))
            for (const Vec3& each : velocity)
                speed = std::max(speed, glm::length(each));
        return speed;
    };
    const double rake = state_.releasing ? fastest(VertexRole::Attached, 1) : 0.0;
    return rake > 0.0 ? rake : fastest(VertexRole::Free, v.slots() / most_sampled + 1);
}

Result<void> MovingSurface::step(double to,
                                 std::stop_token stop,
                                 const WorkPart& work,
                                 std::optional<double> aim) {
    const double reached = next_time(to, stop);
    const double way = std::abs(aim.value_or(to) - time());
    const double part = way > 0.0 ? std::min(1.0, std::abs(reached - time()) / way) : 1.0;
    const WorkPart here = work.rest().between(0.0, part);
    const auto within = move(reached, stop, here);
    if (!within)
        return tl::unexpected(within.error());
    if (!*within)
        if (auto again = start_coarser(reached, stop, work.rest().between(0.0, trial_share));
            !again)
            return again;
    here.reached(1.0);
    work.has(state_.mesh.triangles.quads());
    work.came_to(time(), state_.plan->request.plan.parameters.from);
    return {};
}

/// Takes one step, to next_time(). Returns false if the mesh then has more quads than its rules allow, and is
/// of no use.
Result<bool> MovingSurface::move(double now, const std::stop_token& stop, const WorkPart& work) {
    MovingMesh& mesh = state_.mesh;
    const auto began = clock_->now();
    const double before = mesh.time;
    const double dt = std::abs(now - before);
    const double then = leading_speed(now, stop);
    const auto of_step = [then](double speed) { return then > speeding_up * speed ? then : speed; };

    // Release the row on the rake when it would fall too far behind in this step, or for the last time.
    MaterialVertices& v = mesh.vertices;
    const bool last_release = state_.releasing && mesh.time == state_.plan->release_until;
    std::vector<VertexId> released;
    if (state_.releasing) {
        double fastest = 0.0;
        for (const VertexId i : attached(mesh))
            fastest = std::max(fastest, double(glm::length(v.velocity[i])));
        fastest = of_step(fastest);
        const bool due =
            mesh.triangles.quads() == 0 ||
            state_.row_travel + fastest * dt > row_spacing * state_.separation * (1.0 + 1e-9);
        if (due || last_release)
            released = release_row(mesh);
        state_.row_travel = released.empty() ? state_.row_travel + fastest * dt : fastest * dt;
    }

    const double speed = of_step(largest(v.slots(), 0.0, [&](std::size_t i, double) {
        return v.running(static_cast<VertexId>(i)) ? double(glm::length(v.velocity[i])) : 0.0;
    }));
    const std::uint64_t under_way = running(mesh);
    AdvanceOptions carry = state_.plan->carry;
    // Half a cell, or half a separation, whichever is less, in a step of RK4; fast takes it whole.
    const double reach =
        (state_.plan->fast ? 1.0 : 0.5) * std::min(state_.plan->finest_spacing, state_.separation);
    carry.step = speed > 0.0 ? reach / speed : dt;
    const auto load = this->carry(now, carry, stop);
    if (!load)
        return tl::unexpected(load.error());
    state_.vertex_steps +=
        under_way * static_cast<std::uint64_t>(std::max(1.0, std::ceil(dt / carry.step - 1e-9)));
    end_the_old(mesh, state_.plan->request.plan.parameters);
    count_the_dead(mesh, state_.fresh, state_.terminated);
    move_attached(mesh);
    seconds_.load += *load;
    seconds_.advect += elapsed(*clock_, began) - *load;
    work.reached(carry_share);

    const auto refining = clock_->now();
    if (!released.empty() && !last_release) {
        const auto row = attach_row(mesh, state_.plan->request.origin, *flow_,
                                    seeds_behind(mesh, released, *state_.plan), stop);
        if (!row)
            return tl::unexpected(row.error());
        join_rows(mesh, state_.plan->columns, *row, released);
    }
    state_.releasing = state_.releasing && !last_release;
    state_.fresh = v.next_id();
    if (const auto within = refine(before, carry, stop, work.between(carry_share, 1.0));
        !within || !*within)
        return within;
    ++state_.steps;
    sort_memory(mesh, sorting_share);
    seconds_.refine += elapsed(*clock_, refining);
    assert(validate().empty());
    if (auto sampled = sample_velocity(stop); !sampled)
        return tl::unexpected(sampled.error());
    return true;
}

/// All vertices to `to`, and with them what is known of their errors. Returns the seconds spent waiting for
/// time-steps.
Result<double>
MovingSurface::carry(double to, const AdvanceOptions& options, const std::stop_token& stop) {
    MovingMesh& mesh = state_.mesh;
    const double h = std::abs(to - mesh.time) / rk4_steps(to - mesh.time, options);
    std::optional<StepSample> sample;
    if (state_.plan->estimates &&
        (state_.steps % check_every == 0 || state_.step_errors.too_long(h)))
        sample.emplace(mesh, state_.steps);
    const auto advanced = flow_->advance(mesh.vertices.particles(), to, options, stop);
    if (!advanced)
        return tl::unexpected(advanced.error());
    mesh.time = to;
    if (sample)
        if (auto learnt = sample->learn(state_.step_errors, *flow_, mesh, options, stop); !learnt)
            return tl::unexpected(learnt.error());
    if (state_.plan->estimates && state_.steps % check_every == check_every - 1) {
        add_step_errors(mesh, state_.step_errors, state_.errors_until);
        state_.errors_until = to;
        if (auto traced = trace_doubtful(options, stop); !traced)
            return tl::unexpected(traced.error());
    }
    return advanced->load;
}

/// Traces again the vertices whose errors have come to more than is trusted: in what the flow stretches and
/// folds they grow, whether of interpolation or of steps.
Result<void> MovingSurface::trace_doubtful(const AdvanceOptions& options,
                                           const std::stop_token& stop) {
    const RefinementRules& rules = state_.plan->rules;
    if (!refines() || !rules.retrace || rules.policy == InsertionPolicy::Exact)
        return {};
    std::vector<VertexId> doubtful =
        vertices_beyond(state_.mesh, rules.trusted_error * state_.separation);
    // A vertex that was traced with these very steps would come to the same place. Fast surfaces of cells
    // traced 352,840 vertices again to mend the 6,843 that were interpolated.
    if (options.method == AdvanceOptions::Method::Dopri5)
        std::erase_if(doubtful,
                      [&](VertexId v) { return state_.mesh.vertices.approximated[v] == 0; });
    return retrace(state_.mesh, state_.plan->request.origin, *flow_, doubtful, options, stop);
}

Result<void> MovingSurface::advance_to(double to, std::stop_token stop, const WorkPart& work) {
    while (time() != to) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        if (auto stepped = step(to, stop, work); !stepped)
            return stepped;
    }
    return {};
}

KeyedMesh MovingSurface::mesh() const {
    const bool tangents = state_.plan->request.plan.parameters.tangents;
    return snapshot(state_.mesh, {.deformation = true, .tangents = tangents}, &state_.step_errors,
                    state_.errors_until);
}

std::string MovingSurface::validate() const {
    return violation(state_.mesh);
}

void MovingSurface::restore(const MovingState& state) {
    state_ = state; // into the memory it has
}

SurfaceStatistics MovingSurface::statistics() const {
    SurfaceStatistics s;
    s.kind = state_.plan->request.origin.patch() ? SurfaceKind::Time : SurfaceKind::Streak;
    s.steps = state_.steps;
    s.vertex_steps = state_.vertex_steps;
    s.terminated = state_.terminated;
    s.terminated.time += running(state_.mesh);
    s.torn = state_.torn;
    s.separation = state_.separation;
    s.requested_separation = state_.plan->request.plan.parameters.separation;
    s.seconds = seconds_;
    return s;
}

} // namespace wakesurf::core
