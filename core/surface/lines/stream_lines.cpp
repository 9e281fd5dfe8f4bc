#include "core/surface/lines/stream_lines.hpp"

#include "core/base/rounding.hpp"
#include "core/field/flow_samples.hpp"
#include "core/field/time_in_data.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wakesurf::core {

namespace {

constexpr double gaps_in_domain = 250.0;
constexpr double turn_between = 3.0 * std::numbers::pi / 180.0;
/// Attempts, after which a line ends: one that hops along a wall cell by cell makes no way.
constexpr std::size_t steps_of_line = 50'000;
/// Shares of the points that a curve may have at first: others need less than theirs.
constexpr std::size_t shares_of_curve = 4;
/// Points whose values are sampled together.
constexpr std::size_t sampled_together = std::size_t{1} << 14;
/// Of each of them, besides its value: as of slices.
constexpr std::size_t sample_bytes = 1200;

struct LinePoint {
    Vec3 place{0.0};
    float time = 0.0F;
};

/// What of a point is there at the end: in a curve, in the lines.
constexpr std::size_t point_bytes =
    sizeof(LinePoint) + sizeof(Vec3) + 2 * sizeof(float) + sizeof(std::uint32_t);

/// The points of one curve, taken off its steps as they come.
class Thinning {
  public:
    std::vector<LinePoint> points; ///< behind the seed
    bool cut = false;              ///< at the most points
    CurveEnd end = CurveEnd::Running;

    void begin(const Vec3& seed) { here_ = seed; }

    /// Takes a step up to where the curve is, or to the length. Returns false where the curve ends there.
    bool add(const Curve& curve,
             const CurveStep& step,
             double gap,
             double length,
             std::size_t most,
             WorkMemory& memory) {
        double end = step.dt != 0.0 ? (curve.last.time - step.time) / step.dt : 0.0;
        const bool too_long = curve.last.arc > length;
        if (too_long)
            end = theta_at(step, length, end);
        const auto at = [&](double part) { return step.at(part * end); };
        const glm::dvec4 first = at(0.0), middle = at(0.5), last = at(1.0);
        const double turn = 2.0 * angle(Vec3(middle - first), Vec3(last - middle));
        const int parts = static_cast<int>(std::clamp(
            std::ceil(std::max(turn / turn_between, (last.w - first.w) / gap)), 1.0, 360.0));
        for (int i = 1; i <= parts; ++i) {
            const double part = i / static_cast<double>(parts);
            const glm::dvec4 next = at(part);
            const Vec3 way = Vec3(next) - here_;
            if (pending_ && (next.w - kept_arc_ > gap || angle(kept_way_, way) > turn_between) &&
                !keep(most, memory))
                return false;
            if (points.empty() && !pending_)
                kept_way_ = way;
            here_ = Vec3(next);
            here_way_ = way;
            here_arc_ = next.w;
            here_time_ = static_cast<float>(step.time + part * end * step.dt);
            pending_ = true;
        }
        return !too_long;
    }

    /// Takes the last point too.
    void finish(std::size_t most, WorkMemory& memory) {
        if (pending_ && !cut)
            keep(most, memory);
    }

  private:
    static double angle(const Vec3& a, const Vec3& b) {
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }

    static double theta_at(const CurveStep& step, double arc, double end) {
        double low = 0.0;
        double high = end;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (low + high);
            (step.at(middle).w < arc ? low : high) = middle;
        }
        return high;
    }

    bool keep(std::size_t most, WorkMemory& memory) {
        cut = points.size() + 1 >= most;
        const std::size_t room = points.capacity();
        if (points.size() == room) {
            const std::size_t more = std::max<std::size_t>(room, 32);
            if (!memory.grow(more * point_bytes))
                return false;
            points.reserve(room + more);
        }
        points.push_back({here_, here_time_});
        kept_way_ = here_way_;
        kept_arc_ = here_arc_;
        pending_ = false;
        return !cut;
    }

    Vec3 here_{0.0};
    Vec3 here_way_{0.0}; ///< the direction in which it came there
    Vec3 kept_way_{0.0};
    double here_arc_ = 0.0;
    double kept_arc_ = 0.0;
    float here_time_ = 0.0F;
    bool pending_ = false; ///< `here_` is not kept yet
};

void count(const Thinning& curve, LineEnds& ends) {
    if (curve.cut || curve.end == CurveEnd::Budget)
        ++ends.cut;
    else if (curve.end == CurveEnd::Domain)
        ++ends.domain;
    else if (curve.end == CurveEnd::Obstacle)
        ++ends.wall;
    else if (curve.end == CurveEnd::Stagnation)
        ++ends.rest;
    else
        ++ends.limit;
}

/// Cuts the longest curves, all at one number of points, so that there are at most so many of all.
void cut_longest(std::span<std::vector<Thinning>* const> curves, std::size_t most) {
    std::vector<std::size_t> counts;
    for (const auto* each : curves)
        for (const Thinning& curve : *each)
            counts.push_back(curve.points.size());
    std::sort(counts.begin(), counts.end());
    std::size_t left = most;
    std::size_t longest = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > left / (counts.size() - i)) {
            longest = std::max<std::size_t>(1, left / (counts.size() - i));
            break;
        }
        left -= counts[i];
    }
    for (auto* each : curves)
        for (Thinning& curve : *each)
            if (curve.points.size() > longest) {
                curve.points.resize(longest);
                curve.cut = true;
            }
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

Result<std::vector<Thinning>> trace_one_way(const StreamLinesRequest& request,
                                            const TraceOptions& trace,
                                            double duration,
                                            double length,
                                            std::size_t most,
                                            const Flow& flow,
                                            std::span<const Vec3> seeds,
                                            WorkMemory& memory,
                                            const std::stop_token& stop) {
    std::vector<Curve> curves(seeds.size());
    std::vector<Thinning> out(seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        curves[i].seed = seeds[i];
        curves[i].release = request.time;
        curves[i].duration = duration;
        out[i].begin(seeds[i]);
    }
    const double gap = flow.domain().diagonal() / gaps_in_domain;
    const StepWatch watch = [&](const Curve& curve, const CurveStep& step) {
        return out[static_cast<std::size_t>(&curve - curves.data())].add(curve, step, gap, length,
                                                                         most, memory);
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

void append(const Thinning& back, const Thinning& forth, const Vec3& seed, StreamLines& lines) {
    const auto add = [&](const LinePoint& point) {
        lines.points.push_back(point.place);
        lines.times.push_back(point.time);
    };
    std::for_each(back.points.rbegin(), back.points.rend(), add);
    add({seed, 0.0F});
    std::for_each(forth.points.begin(), forth.points.end(), add);
    lines.offsets.push_back(static_cast<std::uint32_t>(lines.points.size()));
}

Result<void> add_values(const StreamLinesRequest& request,
                        const Flow& flow,
                        const std::stop_token& stop,
                        StreamLines& lines) {
    lines.values.assign(lines.points.size(), std::numeric_limits<float>::quiet_NaN());
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
    for (const float value : lines.values) {
        if (!std::isfinite(value))
            continue;
        const auto [least, most] = lines.range.value_or(std::array{value, value});
        lines.range = {std::min(least, value), std::max(most, value)};
    }
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
    constexpr std::size_t curve_bytes = 2 * (sizeof(Curve) + sizeof(Thinning));
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
    const bool both = request.direction == Direction::Both;
    const std::size_t curves = std::max<std::size_t>(1, inside.size() * (both ? 2 : 1));
    const std::size_t most =
        std::max<std::size_t>(2, shares_of_curve * request.most_points / curves);
    const auto one_way = [&](double sign, Direction not_of) -> Result<std::vector<Thinning>> {
        if (request.direction == not_of)
            return std::vector<Thinning>(inside.size());
        return trace_one_way(request, trace, sign * duration, length, most, flow, inside, memory,
                             stop);
    };
    auto back = one_way(-1.0, Direction::Forward);
    if (!back)
        return tl::unexpected(back.error());
    auto forth = one_way(1.0, Direction::Backward);
    if (!forth)
        return tl::unexpected(forth.error());
    const std::array ways{&*back, &*forth};
    cut_longest(ways, std::max(request.most_points, inside.size()) - inside.size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
        append((*back)[i], (*forth)[i], inside[i], lines);
        if (request.direction != Direction::Forward)
            count((*back)[i], lines.ends);
        if (request.direction != Direction::Backward)
            count((*forth)[i], lines.ends);
    }
    if (!memory.grow(std::min(lines.points.size(), sampled_together) * sample_bytes))
        return tl::unexpected(memory.refusal());
    if (auto valued = add_values(request, flow, stop, lines); !valued)
        return tl::unexpected(valued.error());
    return lines;
}

} // namespace wakesurf::core
