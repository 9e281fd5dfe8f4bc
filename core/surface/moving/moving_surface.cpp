#include "core/surface/moving/moving_surface.hpp"

#include "core/surface/moving/cell_shape.hpp"
#include "core/surface/moving/first_row.hpp"
#include "core/surface/moving/release.hpp"
#include "core/surface/moving/snapshot.hpp"
#include "core/surface/surface_request.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <numbers>

namespace wakesurf::core {

struct MovingSurface::Plan {
    Origin origin;
    Columns columns;
    std::vector<double> places; ///< of a row on the rake
    RefinementRules rules;
    AdvanceOptions carry; ///< its step is chosen anew in every step
    double end = 0.0;
    double release_until = 0.0;
    bool fast = false;
    double finest_spacing = 0.0;
};

namespace {

constexpr double patch_bytes = 350.0; ///< a quad, while it is laid

constexpr double row_spacing = 0.75; // of the separation, as the columns of stream surfaces
constexpr double growth_a_step =
    0.5; // of an edge's length: Hermite interpolation wants edges cut before they double
constexpr double least_of_row =
    1.0 / 16.0; // of the time between rows: one violent cell must not stop the rest
constexpr double sorting_share = 0.125; // of vertices inserted since memory was last in mesh order

InsertionPolicy policy(Accuracy accuracy) {
    return accuracy == Accuracy::Fast       ? InsertionPolicy::Linear
           : accuracy == Accuracy::Balanced ? InsertionPolicy::Hermite
                                            : InsertionPolicy::Exact;
}

Origin origin_of(const Rake& rake, const SurfaceParameters& p) {
    if (p.kind == SurfaceKind::Streak)
        return Origin(rake);
    return p.rake2 ? Origin(rake, *p.rake2, p.from) : Origin(rake, *p.sweep, p.from);
}

/// The larger of `most` and the fastest relative growth of a cell's sides, of those longer than `shortest`. Roots are taken only
/// of what may exceed `most`.
double fastest_growth(const MovingMesh& mesh, const Cell& cell, double shortest, double most) {
    std::array<Vec3, 4> p;
    std::array<Vec3f, 4> v;
    for (std::size_t k = 0; k < 4; ++k) {
        p[k] = mesh.vertices.position[cell.corner[k]];
        v[k] = mesh.vertices.velocity[cell.corner[k]];
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 edge = p[k] - p[(k + 1) % 4];
        const Vec3 apart(v[k] - v[(k + 1) % 4]);
        const double length2 = glm::dot(edge, edge);
        const double apart2 = glm::dot(apart, apart);
        if (apart2 < most * most * length2 * (1.0 - 1e-9))
            continue;
        if (const double length = std::sqrt(length2); length > shortest)
            most = std::max(most, std::sqrt(apart2) / length);
    }
    return most;
}

/// The separation at which a surface that nothing stretches has about the wanted number of quads: keeps a request for millions
/// of columns, or of steps, from being begun. The rest of the budget is kept while the surface moves.
double
coarsest_needed(const Origin& origin, const Box& domain, double travel, std::uint64_t max_quads) {
    constexpr double most_rows = 20'000;
    const double quads = static_cast<double>(max_quads);
    const double way = std::min(travel, 4.0 * glm::length(domain.extent()));
    const double steps = travel / (row_spacing * most_rows);
    if (origin.patch())
        return std::max(steps, 1.01 * std::sqrt(origin.length() * origin.longest_across() / quads));
    return std::max(
        {steps, origin.length() / quads, 0.5 * std::sqrt(origin.length() * way / quads)});
}

double elapsed(const Clock& clock, std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(clock.now() - since).count();
}

} // namespace

MovingSurface::MovingSurface(const Flow& flow, std::shared_ptr<const Plan> plan, const Clock& clock)
    : flow_(&flow), clock_(&clock), plan_(std::move(plan)), end_(plan_->end) {}

Result<MovingSurface> MovingSurface::start(const Flow& flow,
                                           const Rake& rake,
                                           const SurfaceParameters& p,
                                           std::stop_token stop,
                                           const Clock& clock,
                                           const WorkPart& work) {
    const auto began = clock.now();
    if (rake.seeds > p.max_quads)
        return over_limit(p.max_quads, "the rake has more seeds than the surface may have quads",
                          "use fewer seeds or a larger maxQuads");
    const auto speed = largest_speed(flow, rake, p.from, stop);
    if (!speed)
        return tl::unexpected(speed.error());
    Origin origin = origin_of(rake, p);
    const double span = std::abs(p.to - p.from);
    const double sign = p.direction == Direction::Backward ? -1.0 : 1.0;
    const double separation =
        std::max(p.separation, coarsest_needed(origin, flow.domain(), *speed * span, p.max_quads));
    Columns columns = make_columns(origin, rake.seeds, separation);
    RefinementRules rules;
    rules.separation = separation;
    rules.merge = p.merge;
    rules.cosine = p.angle >= 180.0 ? -1.0 : std::cos(p.angle * std::numbers::pi / 180.0);
    rules.least_t = origin.patch() ? 1e-6 : 1e-6 * span;
    // Seeds this close that still part beside an obstacle go round it on either side.
    const double seed_distance = separation / 32.0;
    rules.least_s_at_wall = seed_distance / origin.length();
    rules.least_t_at_wall = origin.patch() ? seed_distance / origin.longest_across() : 0.0;
    rules.policy = policy(p.accuracy);
    rules.tangents = p.accuracy == Accuracy::Balanced || p.deformation;
    rules.retrace = p.accuracy == Accuracy::Exact || flow.resident();
    rules.reconnect = p.reconnect;
    rules.obstacle = flow.obstacle();
    rules.max_quads = p.max_quads;
    // Stored data are only as smooth as their interpolation, which error control of high order would search for kinks:
    // there steps of a fixed part of a cell are as good, and several times faster.
    const bool closed_form = !flow.time_range();
    AdvanceOptions carry;
    carry.method = p.accuracy == Accuracy::Exact && closed_form ? AdvanceOptions::Method::Dopri5
                                                                : AdvanceOptions::Method::Rk4;
    carry.tolerance = trace_tolerance(p.accuracy);
    carry.longest_step = flow.finest_spacing();
    carry.stagnation_speed = p.stagnation_speed * *speed;
    carry.smooth = p.accuracy == Accuracy::Exact;
    std::vector<double> places = seed_places(origin, flow, columns, rules.tear_size * separation);
    const double until = p.release_until ? std::abs(*p.release_until - p.from) : span;
    auto plan =
        std::make_shared<const Plan>(Plan{std::move(origin), std::move(columns), std::move(places),
                                          rules, carry, p.from + sign * span, p.from + sign * until,
                                          p.accuracy == Accuracy::Fast, flow.finest_spacing()});
    MovingSurface surface(flow, std::move(plan), clock);
    surface.state_.mesh.time = p.from;
    surface.state_.separation = separation;
    if (auto begun = surface.begin(stop, work); !begun)
        return tl::unexpected(begun.error());
    surface.seconds_.load = elapsed(clock, began);
    return surface;
}

Result<void> MovingSurface::begin(const std::stop_token& stop, const WorkPart& work) {
    MovingMesh& mesh = state_.mesh;
    mesh.lattice = {plan_->columns.count, plan_->columns.closed, 0.0};
    if (plan_->origin.patch()) {
        const double rows =
            std::max(1.0, std::ceil(plan_->origin.longest_across() / state_.separation - 1e-9));
        mesh.lattice.last_row = rows;
        const double bytes = patch_bytes * plan_->columns.count * rows;
        if (!work.holds(static_cast<std::size_t>(std::min(bytes, 1e15))))
            return fail(Error::Code::Cancelled, "there is not enough memory for the surface");
        if (auto laid = lay_patch(mesh, plan_->origin, *flow_, plan_->columns, rows,
                                  plan_->rules.max_quads, stop);
            !laid)
            return laid;
        Refinement refinement(*flow_, plan_->origin, plan_->rules, plan_->carry,
                              refinement_memory_);
        if (auto refined = refinement.run(mesh, stop, work); !refined)
            return refined;
        state_.separation = refinement.rules().separation;
    } else {
        if (auto row =
                attach_row(mesh, plan_->origin, *flow_, plan_->columns, plan_->places, 0.0, stop);
            !row)
            return tl::unexpected(row.error());
        for (VertexId v = 0; v < mesh.vertices.slots(); ++v)
            state_.terminated.obstacle += mesh.vertices.end[v] == CurveEnd::Obstacle;
        state_.releasing = true;
    }
    return sample_velocity(stop);
}

/// Velocity at every vertex now; the rake's particles leave along it.
Result<void> MovingSurface::sample_velocity(const std::stop_token& stop) {
    MaterialVertices& v = state_.mesh.vertices;
    sample_times_.assign(v.slots(), state_.mesh.time);
    sampled_.resize(v.slots());
    if (auto sampled =
            flow_->sample(v.position, sample_times_, sampled_, stop, plan_->carry.smooth);
        !sampled)
        return sampled;
    for (VertexId i = 0; i < v.slots(); ++i) {
        v.velocity[i] = Vec3f(sampled_[i]);
        if (v.role[i] != VertexRole::Attached)
            continue;
        v.along_t[i] = -sampled_[i];
        v.birth_area[i] = static_cast<float>(glm::length(glm::cross(v.along_s[i], v.along_t[i])));
    }
    return {};
}

/// How far in time the next step may go.
double MovingSurface::step_length(double to) const {
    const MaterialVertices& v = state_.mesh.vertices;
    double rake_speed = 0.0;
    double speed = 0.0;
    for (VertexId i = 0; i < v.slots(); ++i) {
        if (v.role[i] == VertexRole::Unused || v.dead(i))
            continue;
        const double here = glm::length(v.velocity[i]);
        speed = std::max(speed, here);
        if (v.role[i] == VertexRole::Attached)
            rake_speed = std::max(rake_speed, here);
    }
    const double left = std::abs(to - state_.mesh.time);
    const double driving = state_.releasing && rake_speed > 0.0 ? rake_speed : speed;
    if (!(driving > 0.0))
        return left;
    const double row = row_spacing * state_.separation / driving;
    const auto slots = state_.mesh.quads.slots();
    const double shortest = 0.1 * state_.separation;
    const double growth = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, slots.size(), 4096), 0.0,
        [&](const auto& range, double most) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                if (slots[i].live)
                    most = fastest_growth(state_.mesh, slots[i].cell, shortest, most);
            return most;
        },
        [](double a, double b) { return std::max(a, b); });
    const double safe = growth > 0.0 ? growth_a_step / growth : row;
    return std::min(left, std::clamp(safe, least_of_row * row, row));
}

double MovingSurface::next_time(double to) const {
    const double here = state_.mesh.time;
    const double sign = to < here ? -1.0 : 1.0;
    const double until = plan_->release_until;
    const double target =
        state_.releasing && sign * (until - here) > 0.0 && sign * (to - until) > 0.0 ? until : to;
    const double dt = step_length(target);
    return dt == std::abs(target - here) ? target : here + sign * dt;
}

Result<void> MovingSurface::step(double to, std::stop_token stop, const WorkPart& work) {
    MovingMesh& mesh = state_.mesh;
    const auto began = clock_->now();
    const double now = next_time(to);
    const double dt = std::abs(now - mesh.time);

    // Release the row on the rake when it would fall too far behind in this step, or for the last time.
    MaterialVertices& v = mesh.vertices;
    const bool last_release = state_.releasing && mesh.time == plan_->release_until;
    std::vector<VertexId> released;
    if (state_.releasing) {
        double fastest = 0.0;
        for (VertexId i = 0; i < v.slots(); ++i)
            if (v.role[i] == VertexRole::Attached)
                fastest = std::max(fastest, double(glm::length(v.velocity[i])));
        const bool due =
            mesh.quads.live() == 0 ||
            state_.row_travel + fastest * dt > row_spacing * state_.separation * (1.0 + 1e-9);
        if (due || last_release)
            released = release_row(mesh);
        state_.row_travel = released.empty() ? state_.row_travel + fastest * dt : fastest * dt;
    }

    double speed = 0.0;
    std::uint64_t running = 0;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (v.role[i] == VertexRole::Free && v.end[i] == CurveEnd::Running) {
            speed = std::max(speed, double(glm::length(v.velocity[i])));
            ++running;
        }
    AdvanceOptions carry = plan_->carry;
    // Half a cell, or half a separation, whichever is less, in a step of RK4; fast takes it whole.
    const double reach =
        (plan_->fast ? 1.0 : 0.5) * std::min(plan_->finest_spacing, state_.separation);
    carry.step = speed > 0.0 ? reach / speed : dt;
    const auto advanced = flow_->advance(v.particles(plan_->rules.tangents), now, carry, stop);
    if (!advanced)
        return tl::unexpected(advanced.error());
    mesh.time = now;
    state_.vertex_steps +=
        running * static_cast<std::uint64_t>(std::max(1.0, std::ceil(dt / carry.step - 1e-9)));
    carry_on_the_dead(mesh, state_.terminated);
    move_attached(mesh);
    seconds_.load += advanced->load;
    seconds_.advect += elapsed(*clock_, began) - advanced->load;

    const auto refining = clock_->now();
    if (!released.empty() && !last_release) {
        state_.row += 1.0;
        const auto row = attach_row(mesh, plan_->origin, *flow_, plan_->columns,
                                    places_behind(mesh, released, plan_->places), state_.row, stop);
        if (!row)
            return tl::unexpected(row.error());
        join_rows(mesh, *row, released);
    }
    state_.releasing = state_.releasing && !last_release;
    RefinementRules rules = plan_->rules;
    rules.separation = state_.separation;
    Refinement refinement(*flow_, plan_->origin, rules, carry, refinement_memory_);
    if (auto refined = refinement.run(mesh, stop, work); !refined)
        return refined;
    state_.separation = refinement.rules().separation;
    ++state_.steps;
    sort_memory(mesh, sorting_share);
    seconds_.refine += elapsed(*clock_, refining);
    assert(validate().empty());
    return sample_velocity(stop);
}

Result<void> MovingSurface::advance_to(double to, std::stop_token stop, const WorkPart& work) {
    const double from = time();
    while (time() != to) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        if (auto stepped = step(to, stop, work); !stepped)
            return stepped;
        work.reached((time() - from) / (to - from));
    }
    return {};
}

KeyedMesh MovingSurface::mesh() const {
    return snapshot(state_.mesh, plan_->rules.tangents);
}

std::string MovingSurface::validate() const {
    return violation(state_.mesh);
}

void MovingSurface::restore(const MovingState& state) {
    state_ = state; // into the memory it has
}

SurfaceStatistics MovingSurface::statistics() const {
    SurfaceStatistics s;
    s.kind = plan_->origin.patch() ? SurfaceKind::Time : SurfaceKind::Streak;
    s.steps = state_.steps;
    s.vertex_steps = state_.vertex_steps;
    s.terminated = state_.terminated;
    s.separation = state_.separation;
    s.seconds = seconds_;
    s.peak_bytes = state_.bytes();
    return s;
}

} // namespace wakesurf::core
