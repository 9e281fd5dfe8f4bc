#include "core/surface/family/family_trace.hpp"

#include "core/base/rounding.hpp"
#include "core/field/sample_scalar.hpp"
#include "core/integrate/curve.hpp"
#include "core/surface/family/family_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace wakesurf::core {

namespace {

/// Finds the first passages of one curve through a plane, in the order of its steps.
class PlanePassages {
  public:
    /// Adds a step. False: the main passage is found.
    /// @param sign  +1 downstream, -1 upstream
    bool add_step(const SourcePlane& plane, const Curve& curve, const CurveStep& step, double sign);

    /// Ends a curve after its last step. A curve that ends in the plane, as where that is a face of the
    /// domain, passes there.
    /// @param slack  how far from the plane it still ends in it
    void end(const SourcePlane& plane, const Curve& curve, double sign, double slack);

    std::optional<Vec3> main;  ///< the way the normal points, as the flow goes
    std::optional<Vec3> other; ///< the other way

  private:
    void pass(const Vec3& at, bool rising, double sign);

    int side_ = 0; ///< of the plane, where the last step ended; 0: there was none
};

// A step is no longer than a cell, in which the flow hardly turns: a passage there and back within an eighth
// of it is none.
constexpr int parts_of_step = 8;

/// The height over a plane along a step, with the coefficients of its dense output.
struct HeightAlong {
    std::array<double, 5> c;

    HeightAlong(const SourcePlane& plane, const CurveStep& step) : c{} {
        for (std::size_t k = 0; k < c.size(); ++k)
            c[k] = glm::dot(plane.normal, Vec3(step.c[k]));
        c[0] = plane.height(Vec3(step.c[0]));
    }

    double at(double theta) const {
        const double other = 1.0 - theta;
        return c[0] + theta * (c[1] + other * (c[2] + theta * (c[3] + other * c[4])));
    }

    /// Returns where it is 0 between two places with different signs.
    double root(double low, double high) const {
        const bool rising = at(low) < at(high);
        for (int halving = 0; halving < 60 && low < high; ++halving) {
            const double middle = 0.5 * (low + high);
            if (middle == low || middle == high)
                break;
            ((at(middle) < 0.0) == rising ? low : high) = middle;
        }
        return high;
    }
};

void PlanePassages::pass(const Vec3& at, bool rising, double sign) {
    auto& kind = rising == (sign > 0.0) ? main : other;
    if (!kind)
        kind = at;
}

bool PlanePassages::add_step(const SourcePlane& plane,
                             const Curve& curve,
                             const CurveStep& step,
                             double sign) {
    const double begin = plane.height(Vec3(step.c[0]));
    const double way = curve.last.arc - step.c[0].w;
    const double end = step.dt != 0.0 ? (curve.last.time - step.time) / step.dt : 0.0;
    const HeightAlong height(plane, step);
    if (side_ == 0) {
        // A node on the plane, but for rounding, is where it is passed.
        const double rounded =
            1e-12 * (glm::length(plane.point) + glm::length(Vec3(step.c[0])) + step.c[1].w);
        const double slope = height.c[1] + height.c[2];
        side_ = begin > 0.0 ? 1 : -1;
        if (std::abs(begin) <= rounded && slope != 0.0) {
            side_ = slope > 0.0 ? 1 : -1;
            pass(Vec3(step.c[0]), slope > 0.0, sign);
        }
    }
    if (std::abs(begin) > 1.01 * way) // too far away
        return !main;
    double before = 0.0;
    for (int i = 1; i <= parts_of_step && !main; ++i) {
        const double theta = end * i / parts_of_step;
        if (height.at(theta) * side_ < 0.0) {
            pass(Vec3(step.at(height.root(before, theta))), side_ < 0, sign);
            side_ = -side_;
        }
        before = theta;
    }
    return !main;
}

void PlanePassages::end(const SourcePlane& plane, const Curve& curve, double sign, double slack) {
    if (side_ != 0 && std::abs(plane.height(curve.last.position)) <= slack)
        pass(curve.last.position, side_ < 0, sign);
}

/// A flow that passes a face more slowly than this part of the speed runs along it.
constexpr double along_a_face = 1e-6;

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// The reasons for a node without a value.
enum class NodeFate : std::uint8_t { Outside, AtRest, Obstacle, Lost };

NodeFate fate_of(const Curve& curve) {
    switch (curve.end) {
    case CurveEnd::Stagnation:
        return NodeFate::AtRest;
    case CurveEnd::Obstacle:
        return NodeFate::Obstacle;
    case CurveEnd::Domain:
        return NodeFate::Outside;
    default:
        return NodeFate::Lost;
    }
}

/// Follows some nodes on their way to the source.
class NodesOnTheirWay {
  public:
    NodesOnTheirWay(const Flow& flow, const FamilyPlan& plan, std::vector<Vec3> nodes)
        : flow_(flow), plan_(plan), nodes_(std::move(nodes)), source_(nodes_.size()),
          other_(nodes_.size()), fate_(nodes_.size(), NodeFate::Outside) {}

    Result<void> find(const std::stop_token& stop) {
        if (!plan_.plane)
            return follow_inflow(stop);
        return follow_to_plane(-1.0, stop)
            .and_then([&] { return follow_to_plane(+1.0, stop); })
            .map([&] {
                for (std::size_t i = 0; i < nodes_.size(); ++i)
                    if (!source_[i])
                        source_[i] = other_[i];
            });
    }

    /// Returns the place where each meets the source; empty if it does not.
    const std::vector<std::optional<Vec3>>& source() const { return source_; }

    NodeFate fate(std::size_t i) const { return fate_[i]; }

  private:
    Curve curve_from(const Vec3& node, double sign) const {
        Curve curve;
        curve.seed = node;
        curve.release = plan_.time;
        curve.duration = sign * plan_.duration;
        return curve;
    }

    Result<void>
    trace(std::vector<Curve>& curves, const StepWatch& watch, const std::stop_token& stop) const {
        TraceOptions options = plan_.trace;
        options.watch = &watch;
        options.expansion = false;
        return flow_.trace(curves, options, stop).map([](const TraceCost&) {});
    }

    /// Returns whether the flow leaves the domain upstream there, and not only by rounding where it runs
    /// along a face.
    bool enters(const Vec3& place, const Vec3& upstream) const {
        const Box box = flow_.domain();
        const Vec3 slack = rounding(box);
        const double least = along_a_face * glm::length(upstream);
        bool on_face = false;
        for (int axis = 0; axis < 3; ++axis) {
            const bool low = place[axis] <= box.lo[axis] + slack[axis];
            const bool high = place[axis] >= box.hi[axis] - slack[axis];
            on_face = on_face || low || high;
            if ((low && -upstream[axis] > least) || (high && upstream[axis] > least))
                return true;
        }
        return !on_face;
    }

    /// A way upstream that ends at the domain's boundary ends where the flow enters.
    Result<void> follow_inflow(const std::stop_token& stop) {
        std::vector<Curve> curves;
        for (const Vec3& node : nodes_)
            curves.push_back(curve_from(node, -1.0));
        std::vector<Vec3> upstream(curves.size());
        const StepWatch watch = [&](const Curve& curve, const CurveStep& step) {
            constexpr double little = 1e-4; // of the step
            const double end = step.dt != 0.0 ? (curve.last.time - step.time) / step.dt : 0.0;
            upstream[static_cast<std::size_t>(&curve - curves.data())] =
                Vec3(step.at(end + little)) - Vec3(step.at(end - little));
            return curve.last.arc < plan_.length;
        };
        return trace(curves, watch, stop).map([&] {
            for (std::size_t i = 0; i < curves.size(); ++i) {
                fate_[i] = fate_of(curves[i]);
                if (curves[i].end == CurveEnd::Domain && curves[i].attempts > 0 &&
                    enters(curves[i].last.position, upstream[i]))
                    source_[i] = curves[i].last.position;
            }
        });
    }

    Result<void> follow_to_plane(double sign, const std::stop_token& stop) {
        std::vector<Curve> curves;
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!source_[i]) {
                which.push_back(i);
                curves.push_back(curve_from(nodes_[i], sign));
            }
        if (curves.empty())
            return {};
        std::vector<PlanePassages> passages(curves.size());
        const StepWatch watch = [&](const Curve& curve, const CurveStep& step) {
            PlanePassages& here = passages[static_cast<std::size_t>(&curve - curves.data())];
            return here.add_step(*plan_.plane, curve, step, sign) && curve.last.arc < plan_.length;
        };
        return trace(curves, watch, stop).map([&] {
            for (std::size_t k = 0; k < curves.size(); ++k) {
                const std::size_t i = which[k];
                if (curves[k].end == CurveEnd::Domain)
                    passages[k].end(*plan_.plane, curves[k], sign, end_slack());
                source_[i] = passages[k].main;
                if (!other_[i])
                    other_[i] = passages[k].other;
                // Downstream a way usually leaves the domain; what stopped it upstream says more.
                if (sign < 0.0 || fate_[i] == NodeFate::Outside)
                    fate_[i] = fate_of(curves[k]);
            }
        });
    }

    double end_slack() const { return 1e-6 * plan_.trace.longest_step; }

    const Flow& flow_;
    const FamilyPlan& plan_;
    std::vector<Vec3> nodes_;
    std::vector<std::optional<Vec3>> source_;
    std::vector<std::optional<Vec3>> other_; ///< where it passes the plane the other way
    std::vector<NodeFate> fate_;
};

/// Returns the scalar at places of the source.
Result<std::vector<float>> values_at(const std::vector<Vec3>& places,
                                     const Flow& flow,
                                     const FamilyPlan& plan,
                                     const SourceScalar& scalar,
                                     const std::stop_token& stop) {
    if (scalar.source != nullptr) {
        const std::vector<double> times(places.size(), plan.time);
        return sample_scalar(flow, *scalar.source, scalar.scalar, places, times, stop);
    }
    const int axis = coordinate_axis(plan.request.scalar);
    std::vector<float> values(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        values[i] = static_cast<float>(plan.curve ? plan.curve->distance(places[i])
                                                  : places[i][std::max(axis, 0)]);
    return values;
}

void count(FamilyCounts& counts, NodeFate fate) {
    switch (fate) {
    case NodeFate::AtRest:
        ++counts.at_rest;
        return;
    case NodeFate::Obstacle:
        ++counts.obstacle;
        return;
    case NodeFate::Lost:
        ++counts.lost;
        return;
    case NodeFate::Outside:
        ++counts.outside;
    }
}

/// Traces the nodes from `first` on, as many as `out` has values.
Result<void> trace_some(const Flow& flow,
                        const Grid& grid,
                        const FamilyPlan& plan,
                        const SourceScalar& scalar,
                        std::size_t first,
                        std::span<float> out,
                        FamilyCounts& counts,
                        const std::stop_token& stop) {
    std::vector<Vec3> nodes(out.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = node_position(grid, first + i);
    NodesOnTheirWay way(flow, plan, std::move(nodes));
    if (auto found = way.find(stop); !found)
        return found;
    std::vector<Vec3> places;
    for (const auto& place : way.source())
        if (place)
            places.push_back(*place);
    const auto values = values_at(places, flow, plan, scalar, stop);
    if (!values)
        return tl::unexpected(values.error());
    std::size_t next = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = way.source()[i] ? (*values)[next++] : none;
        if (!std::isfinite(out[i])) {
            out[i] = none;
            count(counts, way.fate(i));
            continue;
        }
        const double value = out[i];
        counts.range = counts.reached == 0 ? std::array{value, value}
                                           : std::array{std::min(counts.range[0], value),
                                                        std::max(counts.range[1], value)};
        ++counts.reached;
    }
    return {};
}

Error nothing_reached(const FamilyPlan& plan) {
    if (plan.plane)
        return {Error::Code::InvalidArgument,
                plan.curve ? "no node lies on a streamline that passes the plane of the curve"
                           : "no node lies on a streamline that passes the plane",
                "move it to where the flow passes"};
    return {Error::Code::InvalidArgument,
            "no node was traced back to where the flow enters: the dataset has no inflow",
            "give the scalar on a plane or by a curve instead"};
}

} // namespace

Result<FamilyField> trace_family(const Flow& flow,
                                 const Grid& grid,
                                 const FamilyPlan& plan,
                                 const SourceScalar& scalar,
                                 const std::stop_token& stop,
                                 const WorkPart& work) {
    FamilyField field;
    field.counts.nodes = node_count(grid);
    const auto nodes = static_cast<std::size_t>(field.counts.nodes);
    // Enough for all threads, and few enough that progress moves and memory stays small.
    const std::size_t at_once = std::clamp<std::size_t>(nodes / 256, 1024, 16384);
    constexpr std::size_t node_bytes = 2 * sizeof(Curve) + sizeof(PlanePassages) + 256;
    if (auto room = work.holds(nodes * sizeof(float) + at_once * node_bytes); !room)
        return tl::unexpected(room.error());
    field.values.resize(nodes);
    const std::span<float> all(field.values);
    for (std::size_t first = 0; first < nodes; first += at_once) {
        const auto some = all.subspan(first, std::min(at_once, nodes - first));
        if (auto done = trace_some(flow, grid, plan, scalar, first, some, field.counts, stop);
            !done)
            return tl::unexpected(done.error());
        work.reached(static_cast<double>(first + some.size()) / static_cast<double>(nodes));
    }
    if (field.counts.reached == 0)
        return tl::unexpected(nothing_reached(plan));
    return field;
}

} // namespace wakesurf::core
