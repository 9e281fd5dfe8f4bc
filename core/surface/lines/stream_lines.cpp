#include "core/surface/lines/stream_lines.hpp"

#include "core/base/rounding.hpp"
#include "core/field/flow_samples.hpp"
#include "core/field/time_in_data.hpp"
#include "core/surface/lines/thinned_line.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// Attempts, after which a line ends: one that hops along a wall cell by cell makes no way.
constexpr std::size_t steps_of_line = 50'000;
/// Points whose values are sampled together.
constexpr std::size_t sampled_together = std::size_t{1} << 14;
/// Of each of them, besides its value: as of slices.
constexpr std::size_t sample_bytes = 1200;

/// Returns where in a step its arc length is this one.
double theta_at(const CurveStep& step, double arc, double end) {
    double low = 0.0;
    double high = end;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        (step.at(middle).w < arc ? low : high) = middle;
    }
    return high;
}

/// How long a line may be, and how many points it may have.
struct LineLimits {
    double gap, length;
    std::size_t most;
};

/// Takes a step up to where the curve is, or to the length. Returns false where the line ends there.
bool add_step(ThinnedLine& line,
              const Curve& curve,
              const CurveStep& step,
              const LineLimits& limits,
              WorkMemory& memory) {
    double end = step.dt != 0.0 ? (curve.last.time - step.time) / step.dt : 0.0;
    const bool too_long = curve.last.arc > limits.length;
    if (too_long)
        end = theta_at(step, limits.length, end);
    const auto at = [&](double part) { return step.at(part * end); };
    const glm::dvec4 first = at(0.0), middle = at(0.5), last = at(1.0);
    const double turn = 2.0 * angle_between(Vec3(middle - first), Vec3(last - middle));
    const int parts = static_cast<int>(std::clamp(
        std::ceil(std::max(turn / turn_between, (last.w - first.w) / limits.gap)), 1.0, 360.0));
    for (int i = 1; i <= parts; ++i) {
        const double part = i / static_cast<double>(parts);
        const glm::dvec4 next = at(part);
        if (!line.add({Vec3(next), static_cast<float>(step.time + part * end * step.dt)}, next.w,
                      limits.gap, limits.most, memory))
            return false;
    }
    return !too_long;
}

/// Places all over the domain, none on its faces, and some seeds: how fast the flow is.
std::vector<Vec3> survey(const Box& box, std::span<const Vec3> seeds) {
    std::vector<Vec3> out;
    for (int i = 0; i < 27; ++i)
        out.push_back(box.lo +
                      box.extent() *
                          (Vec3(1 + 2 * (i % 3), 1 + 2 * (i / 3 % 3), 1 + 2 * (i / 9)) / 6.0));
    const std::size_t stride = std::max<std::size_t>(1, seeds.size() / 16);
    for (std::size_t i = 0; i < seeds.size(); i += stride)
        out.push_back(seeds[i]);
    return out;
}

Result<std::vector<ThinnedLine>> trace_one_way(const StreamLinesRequest& request,
                                               const TraceOptions& trace,
                                               double duration,
                                               double length,
                                               std::size_t most,
                                               const Flow& flow,
                                               std::span<const Vec3> seeds,
                                               WorkMemory& memory,
                                               const std::stop_token& stop) {
    std::vector<Curve> curves(seeds.size());
    std::vector<ThinnedLine> out(seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        curves[i].seed = seeds[i];
        curves[i].release = request.time;
        curves[i].duration = duration;
        out[i].begin(seeds[i]);
    }
    const LineLimits limits{flow.domain().diagonal() / gaps_in_domain, length, most};
    const StepWatch watch = [&](const Curve& curve, const CurveStep& step) {
        return add_step(out[static_cast<std::size_t>(&curve - curves.data())], curve, step, limits,
                        memory);
    };
    TraceOptions options = trace;
    options.watch = &watch;
    const auto traced = flow.trace(curves, options, stop);
    if (!traced)
        return tl::unexpected(traced.error());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        out[i].finish(most, memory);
        out[i].end = curves[i].end;
    }
    if (memory.exhausted())
        return tl::unexpected(memory.refusal());
    return out;
}

Result<void> add_values(const StreamLinesRequest& request,
                        const Flow& flow,
                        const std::stop_token& stop,
                        StreamLines& lines) {
    for (std::size_t begin = 0; begin < lines.points.size(); begin += sampled_together) {
        std::vector<Vec3> places;
        std::vector<std::size_t> which;
        const std::size_t end = std::min(begin + sampled_together, lines.points.size());
        for (std::size_t i = begin; i < end; ++i) {
            // Lines end on faces but for rounding.
            const Vec3 place = onto_faces(lines.points[i], flow.domain());
            if (flow.status(place) == PointStatus::Inside) {
                places.push_back(place);
                which.push_back(i);
            }
        }
        const auto values = sample_field(request.field, flow, places, request.time, stop);
        if (!values)
            return tl::unexpected(values.error());
        for (std::size_t k = 0; k < which.size(); ++k)
            lines.values[which[k]] = (*values)[k];
    }
    find_range(lines);
    return {};
}

} // namespace

Result<StreamLines> trace_stream_lines(const StreamLinesRequest& asked,
                                       const Flow& flow,
                                       std::span<const Vec3> seeds,
                                       WorkMemory& memory,
                                       const std::stop_token& stop) {
    StreamLinesRequest request = asked;
    const auto time = time_in_data(flow, request.time);
    if (!time)
        return tl::unexpected(time.error());
    request.time = *time;
    StreamLines lines;
    lines.seeds = static_cast<std::uint32_t>(seeds.size());
    std::vector<Vec3> inside;
    for (std::size_t i = 0; i < seeds.size(); ++i)
        if (flow.status(seeds[i]) == PointStatus::Inside) {
            inside.push_back(seeds[i]);
            lines.seed.push_back(static_cast<std::uint32_t>(i));
        }
    lines.outside = lines.seeds - static_cast<std::uint32_t>(inside.size());
    lines.offsets.push_back(0);
    const auto samples = FlowSamples::at(flow, survey(flow.domain(), inside), request.time, stop);
    if (!samples)
        return tl::unexpected(samples.error());
    constexpr std::size_t curve_bytes = 2 * (sizeof(Curve) + sizeof(ThinnedLine));
    if (!memory.grow(inside.size() * curve_bytes))
        return tl::unexpected(memory.refusal());
    const SurfaceParameters usual;
    TraceOptions trace;
    trace.frozen = true;
    trace.tolerance = trace_tolerance(usual.accuracy);
    trace.longest_step = flow.finest_spacing();
    trace.stagnation_speed = usual.stagnation_speed * samples->fastest();
    trace.most_steps = steps_of_line;
    trace.expansion = false;
    trace.memory = &memory;
    const double length =
        request.length > 0.0 ? request.length : lengths_in_domain * flow.domain().diagonal();
    double duration = request.duration;
    if (!(duration > 0.0)) // what is slower is at rest
        duration = trace.stagnation_speed > 0.0 ? 2.0 * length / trace.stagnation_speed : 1.0;
    const std::size_t most = most_of_curve(request.most_points, inside.size(), request.direction);
    const auto one_way = [&](double sign, Direction not_of) -> Result<std::vector<ThinnedLine>> {
        if (request.direction == not_of)
            return std::vector<ThinnedLine>(inside.size());
        return trace_one_way(request, trace, sign * duration, length, most, flow, inside, memory,
                             stop);
    };
    auto back = one_way(-1.0, Direction::Forward);
    if (!back)
        return tl::unexpected(back.error());
    auto forth = one_way(1.0, Direction::Backward);
    if (!forth)
        return tl::unexpected(forth.error());
    std::vector<LinePoint> begins;
    for (const Vec3& each : inside)
        begins.push_back({each});
    gather_lines(*back, *forth, begins, request.direction, request.most_points, lines);
    if (!memory.grow(std::min(lines.points.size(), sampled_together) * sample_bytes))
        return tl::unexpected(memory.refusal());
    if (auto valued = add_values(request, flow, stop, lines); !valued)
        return tl::unexpected(valued.error());
    return lines;
}

} // namespace wakesurf::core
