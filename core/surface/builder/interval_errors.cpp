#include "core/surface/builder/interval_errors.hpp"

#include "core/surface/moving/moving_plan.hpp"
#include "core/surface/request/sheet_options.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace wakesurf::core {

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
/// Every fourth of them leaves two.
constexpr std::size_t least_times = 5;
/// The errors told from every second and from every fourth stored time, both with `h` squared, differ by twelve times the
/// next term, of which five are left in the first: with this bound it is right within a fifth, were there no further terms.
constexpr double disagreement = 0.5;
/// A part of the separation: what is nearer than that is resolved, whatever the ratio.
constexpr double negligible = 1e-4;
constexpr int rings = 2; ///< of cells round a vertex
/// Lines of a path surface that are traced at a time: their steps are held.
constexpr std::size_t lines_at_once = 256;

/// The stored times that the surface uses, from before its first to after its last.
std::vector<double> stored_times(const Flow& flow, const SurfaceParameters& p) {
    const auto range = flow.time_bounds();
    std::vector<double> times;
    if (!range)
        return times;
    double first = std::min(p.from, p.to), last = std::max(p.from, p.to);
    if (direction_of(p) == Direction::Both)
        first = p.from - (p.to - p.from);
    first = std::max(first, (*range)[0]);
    if (const auto before = flow.next_stored_time(std::nextafter(first, (*range)[1]), -1.0))
        times.push_back(*before);
    for (auto next = flow.next_stored_time(first, +1.0); next;
         next = flow.next_stored_time(*next, +1.0)) {
        times.push_back(*next);
        if (*next >= last)
            break;
    }
    return times;
}

/// Where the particles of vertices come to through another series than the surface's own.
class Twin {
  public:
    Twin(const SurfacePlan& plan, const Surface& surface, const WorkPart& work)
        : plan_(plan), surface_(surface), work_(work) {}

    /// Returns a place for each of the vertices; not a number where the particle does not arrive.
    Result<std::vector<Vec3>> places(const Flow& flow,
                                     std::span<const VertexId> vertices,
                                     double speed,
                                     const std::stop_token& stop) const {
        return plan_.parameters.kind == SurfaceKind::Path ? on_lines(flow, vertices, speed, stop)
                                                          : moved(flow, vertices, speed, stop);
    }

  private:
    Result<std::vector<Vec3>> moved(const Flow& flow,
                                    std::span<const VertexId> vertices,
                                    double speed,
                                    const std::stop_token& stop) const {
        const MovingRequest request(plan_, speed);
        const QuadComplex& mesh = surface_.mesh;
        std::vector<Vec3> place;
        std::vector<double> time;
        std::vector<CurveEnd> end;
        for (const VertexId v : vertices) {
            place.push_back(request.origin.position(mesh.s[v], mesh.t[v]));
            time.push_back(request.origin.release(mesh.t[v]));
            end.push_back(flow.status(place.back()) == PointStatus::Inside ? CurveEnd::Running
                                                                           : CurveEnd::Obstacle);
        }
        AdvanceOptions carry = make_plan(request, surface_.statistics.separation).carry;
        carry.step = speed > 0.0 ? flow.finest_spacing() / speed : time_span(plan_.parameters);
        const double until = surface_.ended.value_or(plan_.parameters.to);
        if (auto done = flow.advance({place, {}, {}, time, end}, until, carry, stop); !done)
            return tl::unexpected(done.error());
        for (std::size_t i = 0; i < place.size(); ++i)
            if (end[i] != CurveEnd::Running)
                place[i] = Vec3(nowhere);
        return place;
    }

    Result<std::vector<Vec3>> on_lines(const Flow& flow,
                                       std::span<const VertexId> vertices,
                                       double speed,
                                       const std::stop_token& stop) const {
        const QuadComplex& mesh = surface_.mesh;
        std::vector<std::size_t> order(vertices.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto line = [&](std::size_t i) {
            const VertexId v = vertices[i];
            return std::pair(mesh.t[v] < 0.0, mesh.s[v]);
        };
        std::ranges::stable_sort(order, {}, line);
        std::vector<Vec3> place(vertices.size(), Vec3(nowhere));
        TraceOptions options = plan_.sheets(surface_.statistics.separation, speed).front().trace;
        options.stretch = false;
        options.expansion = false;
        options.memory = work_.memory();
        for (std::size_t begin = 0; begin < order.size();) {
            const std::size_t before = work_.memory() != nullptr ? work_.memory()->bytes() : 0;
            std::vector<Curve> curves;
            std::vector<std::size_t> begins;
            std::size_t end = begin;
            const bool upstream =
                line(order[begin]).first; // the same for all that are traced at a time
            while (end < order.size() && curves.size() < lines_at_once &&
                   line(order[end]).first == upstream) {
                const auto [back, s] = line(order[end]);
                Curve curve;
                curve.seed = plan_.seeding.at(s);
                curve.release = plan_.parameters.from;
                begins.push_back(end);
                for (; end < order.size() && line(order[end]) == std::pair(back, s); ++end) {
                    const double age = mesh.t[vertices[order[end]]];
                    if (std::abs(age) > std::abs(curve.duration))
                        curve.duration = age;
                }
                if (curve.duration == 0.0)
                    curve.end = CurveEnd::Time;
                curves.push_back(std::move(curve));
            }
            begins.push_back(end);
            if (auto done = flow.trace(curves, options, stop); !done)
                return tl::unexpected(done.error());
            for (std::size_t k = 0; k < curves.size(); ++k)
                for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) {
                    const double age = mesh.t[vertices[order[i]]];
                    if (age == 0.0)
                        place[order[i]] = curves[k].seed;
                    else if (std::abs(age) <= std::abs(curves[k].last.time) * (1.0 + 1e-12))
                        place[order[i]] = curves[k].at_time(age).position;
                }
            begin = end;
            curves = {};
            if (work_.memory() != nullptr)
                work_.memory()->shrink(work_.memory()->bytes() - before);
        }
        return place;
    }

    const SurfacePlan& plan_;
    const Surface& surface_;
    const WorkPart& work_;
};

/// The largest of the numbers round each vertex: a distance is small by chance where its direction turns. Not a
/// number where one of them is none.
std::vector<double> largest_around(const QuadComplex& mesh, const std::vector<double>& of) {
    std::vector<double> largest = of;
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<double> before = largest;
        for (const Cell& cell : mesh.cells) {
            const CellPolygon outline = polygon(cell);
            double most = 0.0;
            for (std::uint32_t i = 0; i < outline.count; ++i)
                if (!(mesh.approximated[outline.vertex[i]] != 0))
                    most = std::isnan(before[outline.vertex[i]]) || std::isnan(most)
                               ? nowhere
                               : std::max(most, before[outline.vertex[i]]);
            for (std::uint32_t i = 0; i < outline.count; ++i) {
                double& here = largest[outline.vertex[i]];
                here = std::isnan(here) || std::isnan(most) ? nowhere : std::max(here, most);
            }
        }
    }
    return largest;
}

} // namespace

std::string no_interval_errors(const SurfacePlan& plan) {
    const SurfaceKind kind = plan.parameters.kind;
    if (kind == SurfaceKind::Stream || kind == SurfaceKind::Level)
        return "the field is frozen: nothing is interpolated between stored times";
    if (!plan.flow->time_bounds())
        return "the flow is known at all times: nothing is interpolated between stored times";
    const std::size_t times = stored_times(*plan.flow, plan.parameters).size();
    return times < least_times ? "the surface uses " + std::to_string(times) +
                                     " stored times, and at least 5 are needed"
                               : "";
}

Result<IntervalErrors> interval_errors(const SurfacePlan& plan,
                                       const Surface& surface,
                                       std::stop_token stop,
                                       const WorkPart& work) {
    const QuadComplex& mesh = surface.mesh;
    IntervalErrors out;
    out.error.assign(mesh.vertices(), static_cast<float>(nowhere));
    const std::vector<double> times = stored_times(*plan.flow, plan.parameters);
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
        out.interval = std::max(out.interval, times[i + 1] - times[i]);
    std::vector<VertexId> traced;
    for (VertexId v = 0; v < mesh.vertices(); ++v)
        if (mesh.approximated[v] == 0)
            traced.push_back(v);
    if (traced.empty())
        return out;
    if (auto room = work.takes(traced.size() * 4 * sizeof(Vec3)); !room)
        return tl::unexpected(room.error());
    const auto speed = plan.largest_speed(stop);
    if (!speed)
        return tl::unexpected(speed.error());
    const Twin twin(plan, surface, work);
    const double from = plan.parameters.from;
    const auto second = twin.places(*plan.flow->thinned(2, from), traced, *speed, stop);
    if (!second)
        return tl::unexpected(second.error());
    const auto fourth = twin.places(*plan.flow->thinned(4, from), traced, *speed, stop);
    if (!fourth)
        return tl::unexpected(fourth.error());
    std::vector<double> near(mesh.vertices(), nowhere), far(mesh.vertices(), nowhere);
    for (std::size_t i = 0; i < traced.size(); ++i) {
        const Vec3& here = mesh.position[traced[i]];
        const Vec3 error = ((*second)[i] - here) / 3.0;
        near[traced[i]] = glm::length(error);
        far[traced[i]] = glm::length(((*fourth)[i] - here) / 15.0 - error);
    }
    const std::vector<double> near_around = largest_around(mesh, near);
    const std::vector<double> far_around = largest_around(mesh, far);
    std::vector<double> resolved;
    const double least = negligible * surface.statistics.separation;
    for (const VertexId v : traced) {
        const bool agree = far_around[v] <= disagreement * near_around[v];
        if (!(agree || near_around[v] <= least) || std::isnan(near[v]))
            continue;
        resolved.push_back(near[v]);
        out.error[v] = static_cast<float>(near[v]);
    }
    if (resolved.empty())
        return out;
    const auto at = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(resolved.size() - 1));
    std::nth_element(resolved.begin(), resolved.begin() + at, resolved.end());
    const double error99 = resolved[static_cast<std::size_t>(at)];
    const double unresolved =
        1.0 - static_cast<double>(resolved.size()) / static_cast<double>(traced.size());
    out.stated = {error99, unresolved};
    if (error99 > 0.0 && unresolved < 0.5)
        out.advised_interval = out.interval * std::sqrt(surface.statistics.separation / error99);
    return out;
}

Result<std::vector<float>> state_interval_errors(const SurfacePlan& plan,
                                                 Surface& surface,
                                                 std::stop_token stop,
                                                 const WorkPart& work) {
    SurfaceStatistics& statistics = surface.statistics;
    statistics.interval_left_out = no_interval_errors(plan);
    if (!statistics.interval_left_out.empty())
        return std::vector<float>{};
    return interval_errors(plan, surface, std::move(stop), work).map([&](IntervalErrors&& errors) {
        statistics.interval_error = errors.stated;
        statistics.advised_interval = errors.advised_interval;
        if (!errors.stated)
            statistics.interval_left_out = "the stored times are too far apart for this surface";
        return std::move(errors.error);
    });
}

} // namespace wakesurf::core
