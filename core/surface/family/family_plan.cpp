#include "core/surface/family/family_plan.hpp"

#include "core/base/rounding.hpp"
#include "core/field/flow_samples.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

namespace wakesurf::core {

namespace {

/// A part of the speed: so small a velocity across something is rounding.
constexpr double nothing = 1e-9;

/// Returns the normal turned the way that most of the flow passes. Error: no flow passes.
Result<Vec3> passed(const FlowSamples& samples, const Vec3& normal, const std::string& what) {
    const double fastest = samples.fastest();
    const auto [sum, largest] = samples.along(normal);
    if (fastest == 0.0)
        return fail(Error::Code::InvalidArgument, "the velocity is zero along " + what,
                    "move it to where the flow passes");
    if (largest <= nothing * fastest)
        return fail(Error::Code::InvalidArgument,
                    "the flow runs along " + what + ", not through it",
                    "no stream surface passes it: turn it across the flow");
    return sum < -nothing * fastest ? -normal : normal;
}

/// Places of a plane inside a box.
std::vector<Vec3> places_of(const SourcePlane& plane, const Box& box) {
    constexpr int most = 32;
    const Vec3 axis = std::abs(plane.normal.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(plane.normal, axis));
    const Vec3 v = glm::cross(plane.normal, u);
    const Vec3 centre = 0.5 * (box.lo + box.hi);
    const Vec3 foot = centre - plane.height(centre) * plane.normal;
    std::vector<Vec3> out;
    for (int i = -most; i <= most; ++i)
        for (int j = -most; j <= most; ++j) {
            const Vec3 p = onto_faces(
                foot + (0.5 * box.diagonal() / most) * (double(i) * u + double(j) * v), box);
            if (box.contains(p))
                out.push_back(p);
        }
    return out;
}

Result<void> check_inside(const SourcePlane& plane, const Box& box) {
    double lowest = plane.height(box.lo);
    double highest = lowest;
    for (int corner = 1; corner < 8; ++corner) {
        const double height = plane.height({(corner & 1) != 0 ? box.hi.x : box.lo.x,
                                            (corner & 2) != 0 ? box.hi.y : box.lo.y,
                                            (corner & 4) != 0 ? box.hi.z : box.lo.z});
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    const Vec3 rounded = rounding(box);
    const double slack = std::max({rounded.x, rounded.y, rounded.z});
    if (lowest <= slack && highest >= -slack)
        return {};
    std::ostringstream text;
    text << "the plane lies outside the domain by " << std::max(lowest, -highest);
    return fail(Error::Code::OutOfDomain, text.str(), "move its point into the domain");
}

Result<SourcePlane>
resolve(const Flow& flow, const FamilyPlane& asked, double time, const std::stop_token& stop) {
    const double length = glm::length(asked.normal);
    if (!finite(asked.point) || !std::isfinite(length) || length == 0.0)
        return fail(Error::Code::InvalidArgument, "the plane's normal has no direction",
                    "give a point and a normal of finite numbers that are not all 0");
    const SourcePlane plane{asked.point, asked.normal / length};
    if (auto inside = check_inside(plane, flow.domain()); !inside)
        return tl::unexpected(inside.error());
    const auto samples = FlowSamples::at(flow, places_of(plane, flow.domain()), time, stop);
    if (!samples)
        return tl::unexpected(samples.error());
    if (samples->place.empty()) // a sliver, which the nodes beside it will find
        return plane;
    return passed(*samples, plane.normal, "the plane").map([&](const Vec3& normal) {
        return SourcePlane{plane.point, normal};
    });
}

/// Returns, of the planes that a straight line lies in, the one that is passed most: across the axis along
/// which the velocities' parts beside the line are largest.
Result<Vec3> most_passed(const FlowSamples& samples, const Rake& line) {
    const Vec3 ahead = glm::normalize(line.points.back() - line.points.front());
    const Vec3 axis = std::abs(ahead.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(ahead, axis));
    const Vec3 v = glm::cross(ahead, u);
    double uu = 0.0;
    double uv = 0.0;
    double vv = 0.0;
    for (const Vec3& velocity : samples.velocity) {
        const double a = glm::dot(velocity, u);
        const double b = glm::dot(velocity, v);
        uu += a * a;
        uv += a * b;
        vv += b * b;
    }
    const double angle = 0.5 * std::atan2(2.0 * uv, uu - vv);
    return passed(samples, std::cos(angle) * u + std::sin(angle) * v, "the curve");
}

Result<void>
resolve(FamilyPlan& plan, const Flow& flow, const Rake& rake, const std::stop_token& stop) {
    auto kept = clip_rake(rake, flow.domain());
    if (!kept)
        return tl::unexpected(kept.error());
    auto normal = PlaneCurve::plane_of(rake);
    if (!normal)
        return tl::unexpected(normal.error());
    const SeedingCurve curve(kept->rake);
    std::vector<Vec3> places;
    constexpr int most = 64;
    for (int i = 0; i <= most; ++i)
        places.push_back(curve.at(static_cast<double>(i) / most));
    const auto samples = FlowSamples::at(flow, places, plan.time, stop);
    if (!samples)
        return tl::unexpected(samples.error());
    auto turned = *normal ? passed(*samples, **normal, "the curve") : most_passed(*samples, rake);
    if (!turned)
        return tl::unexpected(turned.error());
    plan.plane = SourcePlane{rake.points.front(), *turned};
    plan.curve.emplace(rake, *turned);
    return {};
}

} // namespace

Result<FamilyPlan> plan_family(const Flow& flow,
                               const FamilyRequest& request,
                               double time,
                               std::span<const Vec3> some,
                               const std::stop_token& stop) {
    FamilyPlan plan;
    plan.request = request;
    plan.time = time;
    if (!std::isfinite(request.length) || request.length < 0.0)
        return fail(Error::Code::InvalidArgument, "the longest way of a node must not be negative");
    plan.length = request.length > 0.0 ? request.length : 10.0 * flow.domain().diagonal();
    const auto samples = FlowSamples::at(flow, some, time, stop);
    if (!samples)
        return tl::unexpected(samples.error());
    const double fastest = samples->fastest();
    if (!(fastest > 0.0))
        return fail(Error::Code::InvalidArgument, "the velocity is zero at that time",
                    "choose a time at which the flow moves");
    plan.trace.frozen = true;
    plan.trace.tolerance = trace_tolerance(request.accuracy);
    plan.trace.longest_step = flow.finest_spacing();
    plan.trace.stagnation_speed = SurfaceParameters{}.stagnation_speed * fastest;
    plan.duration = plan.length / plan.trace.stagnation_speed;
    Result<void> found;
    if (const auto* plane = std::get_if<FamilyPlane>(&request.source))
        found = resolve(flow, *plane, time, stop).map([&](const SourcePlane& turned) {
            plan.plane = turned;
        });
    else if (const auto* rake = std::get_if<Rake>(&request.source))
        found = resolve(plan, flow, *rake, stop);
    if (!found)
        return tl::unexpected(found.error());
    return plan;
}

} // namespace wakesurf::core
