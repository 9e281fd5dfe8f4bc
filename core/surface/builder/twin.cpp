#include "core/surface/builder/twin.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/builder/trace_vertices.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

constexpr double no_partner = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t age_parts = 10;
/// What comparing takes, in bytes a vertex: places and times traced, and numbers kept.
constexpr std::size_t compared_vertex_bytes = 200;

/// The velocity of each vertex, at the time at which it is there.
Result<std::vector<Vec3>>
velocities(const SurfacePlan& plan, const Surface& surface, const std::stop_token& stop) {
    std::vector<Vec3> out(surface.mesh.vertices());
    return plan.flow
        ->sample(surface.mesh.position, vertex_times(surface, plan.parameters), out, stop,
                 plan.parameters.interpolation == Interpolation::Smooth)
        .map([&] { return std::move(out); });
}

struct Pair {
    double age, distance, lag; ///< distance: not a number without a partner
};

double quantile(std::vector<double>& of, double part) {
    const auto at =
        of.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(of.size() - 1));
    std::nth_element(of.begin(), at, of.end());
    return *at;
}

TwinDistance summed_up(std::span<const Pair> pairs) {
    TwinDistance out;
    std::vector<double> distance, lag;
    for (const Pair& pair : pairs) {
        out.age = std::max(out.age, pair.age);
        if (!std::isnan(pair.distance))
            distance.push_back(pair.distance);
        if (!std::isnan(pair.lag))
            lag.push_back(pair.lag);
    }
    out.compared = static_cast<double>(distance.size()) / static_cast<double>(pairs.size());
    if (!distance.empty()) {
        out.p50 = quantile(distance, 0.5);
        out.p90 = quantile(distance, 0.9);
        out.p99 = quantile(distance, 0.99);
    }
    if (!lag.empty())
        out.lag50 = quantile(lag, 0.5);
    return out;
}

StatedTwin stated(std::vector<Pair> pairs) {
    StatedTwin out;
    out.all = summed_up(pairs);
    std::ranges::stable_sort(pairs, {}, &Pair::age);
    for (std::size_t k = 0, begin = 0; k < age_parts; ++k) {
        const double until = out.all.age * static_cast<double>(k + 1) / age_parts;
        std::size_t end = begin;
        while (end < pairs.size() && (pairs[end].age <= until || k + 1 == age_parts))
            ++end;
        const TwinDistance part =
            end > begin ? summed_up(std::span(pairs).subspan(begin, end - begin)) : TwinDistance{};
        if (part.compared > 0.0)
            out.ages.push_back(part);
        begin = end;
    }
    return out;
}

double age_of(VertexId v, const SurfacePlan& plan, const Surface& surface) {
    if (plan.parameters.kind == SurfaceKind::Stream)
        return std::abs(surface.mesh.t[v]);
    const auto [from, to] = life_of(v, plan, surface);
    return std::abs(to - from);
}

} // namespace

Result<SurfacePlan>
plan_twin(const SurfacePlan& of, std::shared_ptr<const Flow> flow, const TwinSettings& settings) {
    SurfaceParameters p = of.parameters;
    if (p.kind == SurfaceKind::Level)
        return fail(Error::Code::InvalidArgument,
                    "a level surface has no twin: it consists of no particles",
                    "compare a stream, path, streak or time surface");
    p.accuracy = settings.accuracy.value_or(p.accuracy);
    p.interpolation = settings.interpolation.value_or(p.interpolation);
    p.between = settings.between.value_or(p.between);
    Rake rake = of.rake;
    for (Rake* each : {&rake, p.rake2 ? &*p.rake2 : nullptr})
        for (std::size_t i = 0; each != nullptr && i < each->points.size(); ++i)
            each->points[i] += settings.offset.value_or(Vec3(0.0));
    const auto bounds = flow->time_bounds();
    if (bounds && p.kind != SurfaceKind::Stream)
        p.to = std::clamp(p.to, (*bounds)[0], (*bounds)[1]);
    if (p.release_until && between(*p.release_until, p.to, of.parameters.to))
        p.release_until.reset();
    const auto rake2 = p.rake2;
    return plan_surface(std::move(flow), rake, std::move(p))
        .map([&](SurfacePlan plan) {
            // Cut to the domain it would have other parameters s. What begins outside has no partner.
            plan.rake = rake;
            plan.parameters.rake2 = rake2;
            plan.seeding = SeedingCurve(rake);
            return plan;
        })
        .map_error([](Error error) {
            error.message = "the twin: " + error.message;
            return error;
        });
}

Result<TwinComparison> compare_twin(const SurfacePlan& plan,
                                    const Surface& surface,
                                    const SurfacePlan& twin,
                                    const std::stop_token& stop,
                                    const WorkPart& work) {
    const QuadComplex& mesh = surface.mesh;
    if (auto room = work.takes(mesh.vertices() * compared_vertex_bytes); !room)
        return tl::unexpected(room.error());
    const auto bounds = twin.flow->time_bounds();
    const bool frozen = plan.parameters.kind == SurfaceKind::Stream;
    const auto traced = traced_vertices(mesh);
    std::vector<VertexId> in_time;
    for (const VertexId v : traced) {
        const auto [from, to] = life_of(v, plan, surface);
        if (frozen || !bounds ||
            (within_rounding(from, (*bounds)[0], (*bounds)[1]) &&
             within_rounding(to, (*bounds)[0], (*bounds)[1])))
            in_time.push_back(v);
    }
    if (in_time.empty())
        return fail(Error::Code::InvalidArgument,
                    traced.empty() ? "the surface has no vertices that are traced"
                                   : "the twin's data end at " + time_text((*bounds)[1]) +
                                         ": they have no surface at the time that is shown",
                    "choose an earlier time");
    const auto speed = twin.largest_speed(stop);
    if (!speed)
        return tl::unexpected(speed.error());
    auto place = trace_vertices(twin, surface, in_time, *speed, stop, work);
    if (!place)
        return tl::unexpected(place.error());
    const auto velocity = velocities(plan, surface, stop);
    if (!velocity)
        return tl::unexpected(velocity.error());
    TwinComparison out{std::vector<Vec3>(mesh.vertices(), Vec3(no_partner)),
                       std::vector<float>(mesh.vertices(), static_cast<float>(no_partner)),
                       std::vector<float>(mesh.vertices(), static_cast<float>(no_partner)),
                       {}};
    for (std::size_t i = 0; i < in_time.size(); ++i)
        out.place[in_time[i]] = (*place)[i];
    std::vector<Pair> pairs;
    for (const VertexId v : traced) {
        const Vec3 apart = out.place[v] - mesh.position[v], u = (*velocity)[v];
        const double speed_squared = glm::dot(u, u);
        const Pair pair{age_of(v, plan, surface), glm::length(apart),
                        speed_squared > 0.0 ? -glm::dot(apart, u) / speed_squared : no_partner};
        out.distance[v] = static_cast<float>(pair.distance);
        out.lag[v] = static_cast<float>(pair.lag);
        pairs.push_back(pair);
    }
    out.stated = stated(std::move(pairs));
    if (out.stated.all.compared == 0.0)
        return fail(Error::Code::InvalidArgument,
                    "no particle of the surface has a partner: the twin's all end before",
                    "see where the twin's domain and obstacles lie");
    fill_between(mesh, out.distance);
    fill_between(mesh, out.lag);
    return out;
}

TwinBand band_of(const Surface& surface, std::span<const TwinComparison> twins) {
    const QuadComplex& mesh = surface.mesh;
    TwinBand band{mesh.position, {}, {}};
    for (VertexId v = 0; v < mesh.vertices(); ++v) {
        Vec3 sum = mesh.position[v];
        double squares = 0.0;
        double count = 1.0;
        for (const TwinComparison& twin : twins)
            if (!std::isnan(twin.place[v].x)) {
                sum += twin.place[v];
                ++count;
            }
        const Vec3 mean = sum / count;
        const auto add = [&](const Vec3& place) {
            if (const Vec3 off = place - mean; !std::isnan(off.x))
                squares += glm::dot(off, off);
        };
        add(mesh.position[v]);
        for (const TwinComparison& twin : twins)
            add(twin.place[v]);
        band.mean[v] = mean;
        band.spread.push_back(
            static_cast<float>(count > 1.0 ? std::sqrt(squares / count) : no_partner));
        band.arrived.push_back(static_cast<float>(count));
    }
    return band;
}

} // namespace wakesurf::core
