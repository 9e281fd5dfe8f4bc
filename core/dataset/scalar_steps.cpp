#include "core/dataset/scalar_steps.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::core {

ScalarSteps::Values ScalarSteps::find(std::size_t scalar, std::size_t step) {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) {
        return each.scalar == scalar && each.step == step;
    });
    if (found == entries_.end())
        return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return found->values;
}

void ScalarSteps::make_room() {
    while (!entries_.empty() && entries_.size() >= most_)
        entries_.pop_back();
}

Result<ScalarSteps::Values>
ScalarSteps::get(std::size_t scalar, std::size_t step, const std::function<Result<Slab>()>& read) {
    {
        const std::lock_guard lock(mutex_);
        if (auto values = find(scalar, step))
            return values;
        make_room(); // before the next is read: never one more in memory
    }
    auto slab = read();
    if (!slab)
        return tl::unexpected(slab.error());
    auto values = std::make_shared<const Slab>(std::move(*slab));
    const std::lock_guard lock(mutex_);
    if (auto others = find(scalar, step))
        return others;
    make_room();
    entries_.push_front({scalar, step, values});
    return values;
}

} // namespace wakesurf::core
