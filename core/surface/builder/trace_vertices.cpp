#include "core/surface/builder/trace_vertices.hpp"

#include "core/surface/moving/moving_plan.hpp"
#include "core/surface/request/sheet_options.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wakesurf::core {

namespace {

constexpr double not_arrived = std::numeric_limits<double>::quiet_NaN();
/// Lines of a stream or path surface that are traced at a time: their steps are held.
constexpr std::size_t lines_at_once = 256;
constexpr int filled_rings = 2; ///< of cells round a vertex

Result<std::vector<Vec3>> trace_moved(const SurfacePlan& plan,
                                      const Surface& surface,
                                      std::span<const VertexId> vertices,
                                      double speed,
                                      const std::stop_token& stop) {
    const MovingRequest request(plan, speed);
    const QuadComplex& mesh = surface.mesh;
    const Flow& flow = *plan.flow;
    std::vector<Vec3> place;
    std::vector<double> time;
    std::vector<CurveEnd> end;
    for (const VertexId v : vertices) {
        place.push_back(request.origin.position(mesh.s[v], mesh.t[v]));
        time.push_back(request.origin.release(mesh.t[v]));
        end.push_back(flow.status(place.back()) == PointStatus::Inside ? CurveEnd::Running
                                                                       : CurveEnd::Obstacle);
    }
    AdvanceOptions carry = make_plan(request, surface.statistics.separation).carry;
    carry.step = speed > 0.0 ? flow.finest_spacing() / speed : time_span(plan.parameters);
    const double until = surface.ended.value_or(plan.parameters.to);
    if (auto done = flow.advance({place, {}, {}, time, end}, until, carry, stop); !done)
        return tl::unexpected(done.error());
    for (std::size_t i = 0; i < place.size(); ++i)
        if (end[i] != CurveEnd::Running)
            place[i] = Vec3(not_arrived);
    return place;
}

Result<std::vector<Vec3>> trace_lines(const SurfacePlan& plan,
                                      const Surface& surface,
                                      std::span<const VertexId> vertices,
                                      double speed,
                                      const std::stop_token& stop,
                                      const WorkPart& work) {
    const QuadComplex& mesh = surface.mesh;
    std::vector<std::size_t> order(vertices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto line = [&](std::size_t i) {
        const VertexId v = vertices[i];
        return std::pair(mesh.t[v] < 0.0, mesh.s[v]);
    };
    std::ranges::stable_sort(order, {}, line);
    std::vector<Vec3> place(vertices.size(), Vec3(not_arrived));
    TraceOptions options = plan.sheets(surface.statistics.separation, speed).front().trace;
    options.stretch = false;
    options.expansion = false;
    options.memory = work.memory();
    for (std::size_t begin = 0; begin < order.size();) {
        const std::size_t before = work.memory() != nullptr ? work.memory()->bytes() : 0;
        std::vector<Curve> curves;
        std::vector<std::size_t> begins;
        std::size_t end = begin;
        const bool upstream =
            line(order[begin]).first; // the same for all that are traced at a time
        while (end < order.size() && curves.size() < lines_at_once &&
               line(order[end]).first == upstream) {
            const auto [back, s] = line(order[end]);
            Curve curve;
            curve.seed = plan.seeding.at(s);
            curve.release = plan.parameters.from;
            begins.push_back(end);
            for (; end < order.size() && line(order[end]) == std::pair(back, s); ++end) {
                const double age = mesh.t[vertices[order[end]]];
                if (std::abs(age) > std::abs(curve.duration))
                    curve.duration = age;
            }
            if (plan.flow->status(curve.seed) != PointStatus::Inside)
                curve.end = CurveEnd::Domain;
            else if (curve.duration == 0.0)
                curve.end = CurveEnd::Time;
            curves.push_back(std::move(curve));
        }
        begins.push_back(end);
        if (auto done = plan.flow->trace(curves, options, stop); !done)
            return tl::unexpected(done.error());
        for (std::size_t k = 0; k < curves.size(); ++k)
            for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) {
                const double age = mesh.t[vertices[order[i]]];
                if (curves[k].steps.empty() && curves[k].end == CurveEnd::Domain)
                    continue; // the seed is not in the fluid
                if (age == 0.0)
                    place[order[i]] = curves[k].seed;
                else if (std::abs(age) <= std::abs(curves[k].last.time) * (1.0 + 1e-12))
                    place[order[i]] = curves[k].at_time(age).position;
            }
        begin = end;
        curves = {};
        if (work.memory() != nullptr)
            work.memory()->shrink(work.memory()->bytes() - before);
    }
    return place;
}

} // namespace

std::vector<VertexId> traced_vertices(const QuadComplex& mesh) {
    std::vector<VertexId> traced;
    for (VertexId v = 0; v < mesh.vertices(); ++v)
        if (mesh.approximated[v] == 0)
            traced.push_back(v);
    return traced;
}

std::pair<double, double> life_of(VertexId v, const SurfacePlan& plan, const Surface& surface) {
    const SurfaceParameters& p = plan.parameters;
    const double t = surface.mesh.t[v], until = surface.ended.value_or(p.to);
    return p.kind == SurfaceKind::Streak ? std::pair(t, until)
           : p.kind == SurfaceKind::Path ? std::pair(p.from, p.from + t)
                                         : std::pair(p.from, until);
}

Result<std::vector<Vec3>> trace_vertices(const SurfacePlan& through,
                                         const Surface& surface,
                                         std::span<const VertexId> vertices,
                                         double speed,
                                         const std::stop_token& stop,
                                         const WorkPart& work) {
    const SurfaceKind kind = through.parameters.kind;
    return kind == SurfaceKind::Path || kind == SurfaceKind::Stream
               ? trace_lines(through, surface, vertices, speed, stop, work)
               : trace_moved(through, surface, vertices, speed, stop);
}

void fill_between(const QuadComplex& mesh, std::span<float> values) {
    for (int ring = 0; ring < filled_rings; ++ring) {
        std::vector<float> sum(mesh.vertices(), 0.0F);
        std::vector<int> with(mesh.vertices(), 0), without(with);
        for (const Cell& cell : mesh.cells) {
            const CellPolygon outline = polygon(cell);
            for (std::uint32_t i = 0; i < outline.count; ++i) {
                const VertexId v = outline.vertex[i],
                               next = outline.vertex[(i + 1) % outline.count];
                for (const auto& [to, from] : {std::pair(v, next), std::pair(next, v)}) {
                    const bool none = std::isnan(values[from]);
                    sum[to] += none ? 0.0F : values[from];
                    with[to] += none ? 0 : 1;
                    without[to] += none && mesh.approximated[from] == 0 ? 1 : 0;
                }
            }
        }
        for (VertexId v = 0; v < mesh.vertices(); ++v)
            if (mesh.approximated[v] != 0 && std::isnan(values[v]) && with[v] > without[v])
                values[v] = sum[v] / static_cast<float>(with[v]);
    }
}

} // namespace wakesurf::core
