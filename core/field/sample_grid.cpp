#include "core/field/sample_grid.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wakesurf::core {

namespace {

using Range = std::array<double, 2>;

// Limits the nodes of a task: the 56 KB it works on stay in its core's cache, and malloc need not ask the
// system for them.
constexpr std::size_t task_nodes = 1024;

Error not_finite(const Vec3& p, double time) {
    return {Error::Code::InvalidArgument,
            "the velocity at " + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
                std::to_string(p.z) + " at time " + std::to_string(time) +
                " is not a finite 32-bit number",
            "choose other parameters, or a grid without a node there"};
}

/// Calls `work(task, begin, end)` for every `task_nodes` of `count` nodes, in parallel.
template <class Work>
void for_tasks(std::size_t count, const Work& work) {
    const std::size_t tasks = (count + task_nodes - 1) / task_nodes;
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
            work(task, task * task_nodes, std::min(count, (task + 1) * task_nodes));
        });
    });
}

} // namespace

Result<Range> sample_places(const Flow& flow,
                            std::span<const Vec3> places,
                            double time,
                            std::span<float> velocities) {
    std::vector<Vec3> exact(places.size());
    const std::vector<double> times(places.size(), time);
    if (auto sampled = flow.sample(places, times, exact, {}); !sampled)
        return tl::unexpected(sampled.error());
    Range range{std::numeric_limits<double>::infinity(), 0.0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool solid = flow.status(places[i]) == PointStatus::InObstacle;
        const Vec3 v = solid ? Vec3(0.0) : exact[i];
        for (int axis = 0; axis < 3; ++axis)
            velocities[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(v[axis]);
        const auto* rounded = &velocities[3 * i];
        if (!std::isfinite(rounded[0]) || !std::isfinite(rounded[1]) || !std::isfinite(rounded[2]))
            return tl::unexpected(not_finite(places[i], time));
        if (solid)
            continue;
        const double speed = std::hypot(rounded[0], rounded[1], rounded[2]);
        range = {std::min(range[0], speed), std::max(range[1], speed)};
    }
    return range;
}

Result<Range> sample_nodes(const Flow& flow,
                           const UniformGrid& grid,
                           std::size_t first,
                           double time,
                           std::span<float> velocities,
                           std::stop_token stop) {
    const std::size_t count = velocities.size() / 3;
    std::vector<Result<Range>> parts((count + task_nodes - 1) / task_nodes, Range{});
    for_tasks(count, [&](std::size_t task, std::size_t begin, std::size_t end) {
        const auto out = velocities.subspan(3 * begin, 3 * (end - begin));
        std::vector<Vec3> places(end - begin);
        for (std::size_t i = begin; i < end; ++i)
            places[i - begin] = node_position(grid, first + i);
        if (stop.stop_requested())
            parts[task] = fail(Error::Code::Cancelled, "sampling the flow was cancelled");
        else
            parts[task] = sample_places(flow, places, time, out);
    });
    Range range{std::numeric_limits<double>::infinity(), 0.0};
    for (const auto& part : parts) {
        if (!part)
            return part;
        range = {std::min(range[0], (*part)[0]), std::max(range[1], (*part)[1])};
    }
    return range;
}

void sample_mask(const Flow& flow,
                 const UniformGrid& grid,
                 std::size_t first,
                 std::span<std::uint8_t> fluid) {
    for_tasks(fluid.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            fluid[i] = flow.status(node_position(grid, first + i)) != PointStatus::InObstacle;
    });
}

} // namespace wakesurf::core
