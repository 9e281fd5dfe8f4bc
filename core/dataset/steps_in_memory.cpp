#include "core/dataset/steps_in_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <utility>

namespace wakesurf::core {

StepsInMemory::StepsInMemory(Grid grid, std::vector<double> times, SolidMask mask)
    : grid_(std::move(grid)), mask_(std::move(mask)), times_(std::move(times)),
      bytes_(node_count(grid_) * 3 * sizeof(float)) {}

Result<std::shared_ptr<const StepsInMemory>> StepsInMemory::make(
    Grid grid, std::vector<double> times, const std::vector<Velocity>& velocity, SolidMask mask) {
    const auto wrong = [](std::string message) {
        return fail(Error::Code::InvalidArgument, std::move(message));
    };
    const std::size_t nodes = node_count(grid);
    if (times.empty() || !std::ranges::all_of(times, [](double t) { return std::isfinite(t); }) ||
        std::ranges::adjacent_find(times, std::greater_equal<>()) != times.end())
        return wrong("the times do not rise strictly");
    if (velocity.size() != times.size())
        return wrong(std::to_string(velocity.size()) + " velocity arrays for " +
                     std::to_string(times.size()) + " times");
    if (!mask.empty() && mask.fluid.size() != nodes)
        return wrong("the mask has " + std::to_string(mask.fluid.size()) + " bytes for " +
                     std::to_string(nodes) + " nodes");
    auto made = std::shared_ptr<StepsInMemory>(
        new StepsInMemory(std::move(grid), std::move(times), std::move(mask)));
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        if (velocity[i].size() != 3 * nodes)
            return wrong("time-step " + std::to_string(i) + " has " +
                         std::to_string(velocity[i].size()) + " numbers, not 3 for each of " +
                         std::to_string(nodes) + " nodes");
        auto step = std::make_shared<TimeStep>();
        step->index = i;
        step->time = made->times_[i];
        step->slab = Slab(made->bytes_);
        std::memcpy(step->slab.bytes().data(), velocity[i].data(), made->bytes_);
        step->gaps =
            !std::ranges::all_of(velocity[i], [](float value) { return std::isfinite(value); });
        made->steps_.push_back(std::move(step));
    }
    return made;
}

Result<std::shared_ptr<const TimeStep>> StepsInMemory::load(std::size_t index,
                                                            std::stop_token) const {
    if (index >= steps_.size())
        return fail(Error::Code::NotFound, "there is no time-step " + std::to_string(index));
    return steps_[index];
}

} // namespace wakesurf::core
