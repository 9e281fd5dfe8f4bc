#include "server/net/methods/import_waiters.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

std::uint64_t
ImportWaiters::wait(const std::string& dataset, std::chrono::milliseconds patience, Waiter waiter) {
    catalogue_.start_import(dataset);
    const auto status = catalogue_.status(dataset);
    if (!status || status->state != DatasetState::Importing || patience.count() <= 0) {
        waiter(status);
        return 0;
    }
    if (waiting_.size() >= limits::import_waiters) {
        waiter(core::over_limit(limits::import_waiters, "too many calls wait for imports",
                                "wait until some of them are answered"));
        return 0;
    }
    const std::uint64_t id = next_++;
    auto timer = loop_.after(patience, [this, id] { answer(id); });
    waiting_.push_back({id, dataset, std::move(waiter), std::move(timer)});
    return id;
}

void ImportWaiters::leave(std::uint64_t ticket, Leaving how) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.id == ticket; });
    if (found == waiting_.end())
        return;
    const std::string dataset = found->dataset;
    waiting_.erase(found);
    const bool wanted = std::any_of(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.dataset == dataset; });
    if (how == Leaving::AndStop && !wanted)
        catalogue_.stop_import(dataset);
}

void ImportWaiters::changed(const std::string& dataset) {
    const auto status = catalogue_.status(dataset);
    if (!status || status->state == DatasetState::Importing)
        return;
    std::vector<std::uint64_t> done;
    for (const Waiting& each : waiting_)
        if (each.dataset == dataset)
            done.push_back(each.id);
    for (const std::uint64_t id : done)
        answer(id);
}

void ImportWaiters::answer(std::uint64_t id) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.id == id; });
    if (found == waiting_.end())
        return;
    const Waiting one = std::move(*found);
    waiting_.erase(found);
    one.waiter(catalogue_.status(one.dataset));
}

} // namespace wakesurf::server
