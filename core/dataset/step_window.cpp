#include "core/dataset/step_window.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::core {

std::shared_ptr<const TimeStep> StepWindow::lend(const std::shared_ptr<StepWindow>& self,
                                                 std::size_t index) {
    StepEntry& entry = entries[index];
    entry.last_use = ++clock;
    if (auto shared = entry.lease.lock())
        return shared;
    if (entry.leases++ == 0)
        ++lent;
    // The lease keeps window and step alive, so it may outlive the cache.
    std::shared_ptr<const TimeStep> lease(
        entry.step.get(), [keep = self, index, step = entry.step](const TimeStep*) mutable {
            step.reset();
            // Out of the capture, which the window's own weak_ptr keeps.
            const auto window = std::move(keep);
            window->put_back(index);
        });
    entry.lease = lease;
    return lease;
}

void StepWindow::put_back(std::size_t index) {
    bool room_wanted = false;
    {
        const std::scoped_lock lock(mutex);
        if (--entries[index].leases == 0)
            --lent;
        ++progress;
        room_wanted = !demanded.empty() || !prefetched.empty();
    }
    if (room_wanted)
        work.notify_one();
}

void StepWindow::demand(std::size_t index) {
    if (entries[index].state == StepState::Cold &&
        std::find(demanded.begin(), demanded.end(), index) == demanded.end())
        demanded.push_back(index);
    if (entries[index].state == StepState::Cold && idle_threads == 0)
        stop_loads([](const StepEntry& other) { return other.waiters == 0; });
}

void StepWindow::withdraw(std::size_t index) {
    if (--entries[index].waiters == 0)
        std::erase(demanded, index);
}

/// Time-steps there may be as things stand.
std::size_t StepWindow::room() const {
    return starved ? std::min(capacity, std::max(used.load(), smallest)) : capacity;
}

bool StepWindow::may_be_deadlocked() const {
    return lent >= room() && lent <= held;
}

/// Makes room for one more time-step within what is free: others are not asked while the window is locked.
bool StepWindow::make_room(std::size_t leave) {
    if (used >= capacity)
        return false;
    const bool there =
        !account || used < smallest || share.grow_within_free((used + 1) * step_bytes, leave);
    starved = !there;
    return there;
}

void StepWindow::count() {
    share.shrink_to(std::max(used.load(), smallest) * step_bytes);
}

/// Removes unused steps beyond the smallest window, and returns them to be freed without the lock.
std::vector<std::shared_ptr<const TimeStep>> StepWindow::reclaim_spare(std::size_t bytes) {
    std::vector<std::shared_ptr<const TimeStep>> freed;
    while (used > smallest && freed.size() * step_bytes < bytes) {
        const auto out = victim(false);
        if (!out)
            break;
        freed.push_back(evict(*out));
    }
    count();
    return freed;
}

std::shared_ptr<const TimeStep> StepWindow::evict(std::size_t index) {
    StepEntry& entry = entries[index];
    auto step = std::move(entry.step);
    entry.step.reset();
    entry.lease.reset();
    entry.state = StepState::Cold;
    --used;
    return step;
}

// Returns the least recently used time-step outside the window; inside it the farthest from its position.
std::optional<std::size_t> StepWindow::victim(bool spare_window) const {
    std::optional<std::size_t> best;
    const auto distance = [&](std::size_t i) { return i > position ? i - position : position - i; };
    const auto better = [&](std::size_t a, std::size_t b) {
        if (entries[a].in_window != entries[b].in_window)
            return entries[b].in_window;
        return entries[a].in_window ? distance(a) > distance(b)
                                    : entries[a].last_use < entries[b].last_use;
    };
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const StepEntry& entry = entries[i];
        const bool free = entry.state == StepState::Resident && entry.leases == 0 &&
                          entry.waiters == 0 && !(spare_window && entry.in_window);
        if (free && (!best || better(i, *best)))
            best = i;
    }
    return best;
}

std::optional<StepJob> StepWindow::pick() {
    if (closing)
        return std::nullopt;
    while (!demanded.empty() && entries[demanded.front()].state != StepState::Cold)
        demanded.pop_front();
    if (!demanded.empty()) {
        auto job = start(demanded.front(), false);
        if (job)
            demanded.pop_front();
        return job; // no room for what is waited for: nothing is loaded ahead either
    }
    while (!prefetched.empty() && entries[prefetched.front()].state != StepState::Cold)
        prefetched.pop_front();
    if (prefetched.empty())
        return std::nullopt;
    auto job = start(prefetched.front(), true);
    if (job)
        prefetched.pop_front();
    return job;
}

std::optional<StepJob> StepWindow::start(std::size_t index, bool spare_window) {
    StepJob job;
    job.index = index;
    if (!make_room(account ? account->budget() / left_free : 0)) {
        if (const auto out = victim(spare_window))
            job.evicted = evict(*out);
        else if (spare_window || !make_room(0))
            return std::nullopt;
    }
    StepEntry& entry = entries[index];
    entry.state = StepState::Loading;
    entry.load = std::stop_source();
    job.stop = entry.load.get_token();
    ++used;
    return job;
}

void StepWindow::finish(std::size_t index, Result<std::shared_ptr<const TimeStep>> loaded) {
    const std::scoped_lock lock(mutex);
    StepEntry& entry = entries[index];
    ++progress;
    if (loaded) {
        ++loads;
        entry.step = std::move(*loaded);
        entry.state = StepState::Resident;
        entry.last_use = ++clock;
        return;
    }
    entry.state = StepState::Cold;
    --used;
    count();
    if (entry.load.stop_requested() && !closing) { // it had made way; it may be wanted again
        if (entry.waiters > 0)
            demanded.push_front(index);
        else if (entry.in_window)
            prefetched.push_front(index);
        return;
    }
    ++entry.failures;
    entry.error = std::move(loaded.error());
}

} // namespace wakesurf::core
