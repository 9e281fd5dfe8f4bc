#include "core/surface/builder/interval_errors.hpp"

#include "core/surface/builder/trace_vertices.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace wakesurf::core {

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
/// The part of the error by which every third stored time may tell another one than every second. Both have the next
/// term besides the one with h squared; with this bound the error is right within a fifth, were there no further terms.
constexpr double disagreement = 0.5;
/// The part of the error by which the errors may differ with where every second stored time begins.
constexpr double difference = 0.7;
/// A part of the separation: what is nearer than that is resolved, whatever the ratio.
constexpr double negligible = 1e-4;
constexpr int rings = 2; ///< of cells round a vertex
/// The part of the vertices that may be unresolved where an interval is advised. Up to it 24 of 25 pieces of advice for six
/// closed forms led to half to twice the separation, and one to 2.3 times; at a part of 0.44 one led to 32 times.
constexpr double most_unresolved = 0.18;
/// What tracing takes, in bytes a vertex: places through five series, and numbers round each vertex.
constexpr std::size_t traced_vertex_bytes = 260;

/// The stored times that the surface uses, from before its first to after its last.
std::vector<double>
stored_times(const Flow& flow, const SurfaceParameters& p, std::optional<double> ended) {
    const auto range = flow.time_bounds();
    std::vector<double> times;
    if (!range)
        return times;
    const double to = ended.value_or(p.to);
    double first = std::min(p.from, to), last = std::max(p.from, to);
    if (direction_of(p) == Direction::Both)
        first = p.from - (to - p.from);
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

/// How large the error of interpolating between stored times becomes, but for a factor that is the flow's: the square of
/// the interval, integrated over time.
class SquaredIntervals {
  public:
    explicit SquaredIntervals(std::vector<double> times) : times_(std::move(times)) {
        for (std::size_t i = 1; i < times_.size(); ++i)
            until_.push_back(until_.back() + std::pow(times_[i] - times_[i - 1], 3.0));
    }

    double between(double from, double to) const { return std::abs(until(to) - until(from)); }

  private:
    double until(double time) const {
        const auto after = std::ranges::upper_bound(times_, time);
        const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            after - times_.begin(), 1, static_cast<std::ptrdiff_t>(times_.size()) - 1));
        const double interval = times_[i] - times_[i - 1];
        return until_[i - 1] + (time - times_[i - 1]) * interval * interval;
    }

    std::vector<double> times_; ///< at least two
    std::vector<double> until_{0.0};
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

std::string no_interval_errors(const SurfacePlan& plan, std::optional<double> ended) {
    const SurfaceKind kind = plan.parameters.kind;
    if (kind == SurfaceKind::Stream || kind == SurfaceKind::Level)
        return "the field is frozen: nothing is interpolated between stored times";
    if (!plan.flow->time_bounds())
        return "the flow is known at all times: nothing is interpolated between stored times";
    if (plan.parameters.between != Between::Linear ||
        plan.parameters.interpolation != Interpolation::Linear)
        return "it is estimated only of what is linear between stored times";
    const std::size_t times = stored_times(*plan.flow, plan.parameters, ended).size();
    return times < least_stored_times ? "the surface uses " + std::to_string(times) +
                                            " stored times, and at least 5 are needed"
                                      : "";
}

Result<void> state_interval_errors(const SurfacePlan& plan,
                                   Surface& surface,
                                   std::stop_token stop,
                                   const WorkPart& work) {
    SurfaceStatistics& statistics = surface.statistics;
    QuadComplex& mesh = surface.mesh;
    statistics.interval_left_out = no_interval_errors(plan, surface.ended);
    const std::vector<VertexId> traced = traced_vertices(mesh);
    if (statistics.interval_left_out.empty() && traced.empty())
        statistics.interval_left_out = "the surface has no vertices that are traced";
    if (!statistics.interval_left_out.empty())
        return {};
    if (auto room = work.takes(traced.size() * traced_vertex_bytes); !room)
        return tl::unexpected(room.error());
    const auto speed = plan.largest_speed(stop);
    if (!speed)
        return tl::unexpected(speed.error());
    const std::vector<double> times = stored_times(*plan.flow, plan.parameters, surface.ended);
    const SquaredIntervals every(times);

    /// Where particles come to through every `stride`-th stored time from the one that is `begin`, and how much
    /// larger that makes the error.
    struct Through {
        std::vector<Vec3> place;
        std::vector<double> larger;
    };

    const auto through = [&](std::size_t stride, std::size_t begin) -> Result<Through> {
        const auto thin = plan.flow->thinned(stride, times[begin]);
        const SquaredIntervals left(stored_times(*thin, plan.parameters, surface.ended));
        std::vector<double> larger;
        for (const VertexId v : traced) {
            const auto [from, to] = life_of(v, plan, surface);
            const double all = every.between(from, to);
            larger.push_back(all > 0.0 ? left.between(from, to) / all : 1.0);
        }
        SurfacePlan thinned = plan;
        thinned.flow = thin;
        return trace_vertices(thinned, surface, traced, *speed, stop, work)
            .map([&](std::vector<Vec3>&& place) {
                return Through{std::move(place), std::move(larger)};
            });
    };
    std::vector<Through> series;
    for (const std::size_t stride : {std::size_t{2}, std::size_t{3}})
        for (std::size_t begin = 0; begin < 2; ++begin) { // a third one costs more than it tells
            auto one = through(stride, begin);
            if (!one)
                return tl::unexpected(one.error());
            series.push_back(*std::move(one));
        }
    // Not a number where a particle does not arrive through one of the series.
    std::vector<double> error(mesh.vertices(), nowhere), by_third(error), by_begin(error);
    for (std::size_t i = 0; i < traced.size(); ++i) {
        const VertexId v = traced[i];
        /// The error by two series together; zero where they are no coarser for this vertex.
        const auto told = [&](const Through& a, const Through& b) {
            const double larger = 0.5 * (a.larger[i] + b.larger[i]) - 1.0;
            const Vec3 off = 0.5 * (a.place[i] + b.place[i]) - mesh.position[v];
            return off * (larger > 1e-6 ? 1.0 / larger : 0.0);
        };
        const Vec3 off = told(series[0], series[1]);
        error[v] = glm::length(off);
        by_third[v] = glm::length(told(series[2], series[3]) - off);
        // Young particles have met no interval that is longer in one of the two.
        const bool both = std::min(series[0].larger[i], series[1].larger[i]) > 1.5;
        by_begin[v] =
            both ? 0.5 * glm::length(told(series[0], series[0]) - told(series[1], series[1]))
                 : 0.0 * error[v];
    }
    const std::vector<double> error_around = largest_around(mesh, error);
    const std::vector<double> third_around = largest_around(mesh, by_third);
    const std::vector<double> begin_around = largest_around(mesh, by_begin);
    std::vector<double> resolved;
    mesh.interval_error.assign(mesh.vertices(), static_cast<float>(nowhere));
    for (const VertexId v : traced) {
        const bool agree = third_around[v] <= disagreement * error_around[v] &&
                           begin_around[v] <= difference * error_around[v];
        if (!agree && !(error_around[v] <= negligible * statistics.separation))
            continue;
        resolved.push_back(error[v]);
        mesh.interval_error[v] = static_cast<float>(error[v]);
    }
    fill_between(mesh, mesh.interval_error);
    if (resolved.empty()) {
        statistics.interval_left_out = "the stored times are too far apart for this surface";
        return {};
    }
    const auto at = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(resolved.size() - 1));
    std::nth_element(resolved.begin(), resolved.begin() + at, resolved.end());
    const double error99 = resolved[static_cast<std::size_t>(at)];
    const double unresolved =
        1.0 - static_cast<double>(resolved.size()) / static_cast<double>(traced.size());
    statistics.interval_error = {error99, unresolved};
    double longest = 0.0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
        longest = std::max(longest, times[i + 1] - times[i]);
    if (error99 > 0.0 && unresolved <= most_unresolved)
        statistics.advised_interval = longest * std::sqrt(statistics.separation / error99);
    return {};
}

} // namespace wakesurf::core
