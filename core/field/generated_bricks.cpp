#include "core/field/generated_bricks.hpp"

#include "core/base/for_each_index.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/field/sample_grid.hpp"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace wakesurf::core {

using Made = Result<std::shared_ptr<const GeneratedBricks>>;

Made GeneratedBricks::make(std::string_view flow,
                           const UniformGrid& grid,
                           std::vector<double> times,
                           std::uint32_t cells,
                           std::size_t threads) {
    auto made = make_analytic_flow(flow);
    if (!made)
        return tl::unexpected(made.error());
    if (std::any_of(grid.dimensions.begin(), grid.dimensions.end(), [](auto n) { return n < 2; }))
        return fail(Error::Code::InvalidArgument, "the grid is thinner than two nodes");
    const auto rises = [](double a, double b) { return !(a < b); };
    if (times.empty() || std::adjacent_find(times.begin(), times.end(), rises) != times.end())
        return fail(Error::Code::InvalidArgument, "the times do not rise strictly");
    return std::shared_ptr<const GeneratedBricks>(
        new GeneratedBricks(std::move(*made), grid, std::move(times), cells, threads));
}

GeneratedBricks::GeneratedBricks(std::unique_ptr<Flow> flow,
                                 const UniformGrid& grid,
                                 std::vector<double> times,
                                 std::uint32_t cells,
                                 std::size_t threads)
    : flow_(std::move(flow)), grid_(grid), times_(std::move(times)),
      layout_(grid.dimensions, cells), threads_(threads) {
    if (!flow_->obstacle())
        return;
    BrickBytes fluid(layout_);
    std::vector<std::uint8_t> own(layout_.nodes_per_brick());
    for (std::size_t brick = 0; brick < layout_.count(); ++brick) {
        for_each_index(own.size(), [&](std::size_t node) {
            own[node] = flow_->status(position(brick, node)) != PointStatus::InObstacle;
        });
        fluid.set(brick, own);
    }
    mask_.bricks = std::make_shared<const BrickBytes>(std::move(fluid));
}

std::size_t GeneratedBricks::bytes_per_step() const {
    return Slab::reservation(3 * sizeof(float) * node_count(grid_));
}

Result<std::shared_ptr<const TimeStep>> GeneratedBricks::load(std::size_t index,
                                                              std::stop_token) const {
    return fail(Error::Code::Unsupported,
                "time-step " + std::to_string(index) + " is generated brick by brick only");
}

void GeneratedBricks::read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const {
    struct Asked {
        std::vector<BrickRead> reads;
        std::stop_token stop;
        Done done;
    };

    const auto asked =
        std::make_shared<const Asked>(Asked{std::move(reads), std::move(stop), std::move(done)});
    std::vector<WorkerThreads::Work> work;
    for (std::size_t i = 0; i < asked->reads.size(); ++i)
        work.emplace_back([this, asked, i](bool ending) {
            if (ending || asked->stop.stop_requested())
                asked->done(i, fail(Error::Code::Cancelled, "reading bricks was cancelled"));
            else
                asked->done(i, sample(asked->reads[i], asked->stop));
        });
    threads_.add(std::move(work));
}

Vec3 GeneratedBricks::position(std::size_t brick, std::size_t node) const {
    const auto& grid = std::get<UniformGrid>(grid_);
    const auto& nodes = layout_.brick_nodes();
    const auto first = layout_.first_node(brick);
    const std::array<std::size_t, 3> at{first[0] + node % nodes[0],
                                        first[1] + node / nodes[0] % nodes[1],
                                        first[2] + node / nodes[0] / nodes[1]};
    const auto along = [&](std::size_t axis) {
        return std::min<std::size_t>(at[axis], grid.dimensions[axis] - 1);
    };
    return grid.origin + grid.spacing * Vec3(along(0), along(1), along(2));
}

Result<void> GeneratedBricks::sample(const BrickRead& read, const std::stop_token& stop) const try {
    const auto name = [&] {
        return "brick " + std::to_string(read.brick) + " of time-step " + std::to_string(read.step);
    };
    if (read.step >= times_.size() || read.brick >= layout_.count() || read.field != 0)
        return fail(Error::Code::NotFound, "there is no " + name());
    if (read.to.size() != 3 * layout_.nodes_per_brick())
        return fail(Error::Code::InvalidArgument,
                    "there is room for another number of nodes than " + name() + " has");
    std::vector<Vec3> layer(std::size_t{layout_.brick_nodes()[0]} * layout_.brick_nodes()[1]);
    for (std::size_t k = 0; k < layout_.brick_nodes()[2]; ++k) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "reading " + name() + " was cancelled");
        for (std::size_t at = 0; at < layer.size(); ++at)
            layer[at] = position(read.brick, layer.size() * k + at);
        const auto to = read.to.subspan(3 * layer.size() * k, 3 * layer.size());
        if (auto sampled = sample_places(*flow_, layer, times_[read.step], to); !sampled)
            return tl::unexpected(sampled.error());
    }
    return {};

} catch (const std::exception& problem) {

    return fail(Error::Code::OverLimit, std::string("a brick cannot be made: ") + problem.what());
}

} // namespace wakesurf::core
