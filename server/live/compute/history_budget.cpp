#include "server/live/compute/history_budget.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <list>
#include <mutex>
#include <utility>
#include <vector>

namespace wakesurf::server {

namespace {

constexpr std::size_t least_history = std::size_t{1} << 20;

} // namespace

struct HistoryBudget::Entry {
    Permit::GiveWay give_way;
    std::size_t bytes = 0; ///< taken; in use: that may be taken
    bool in_use = false;
    Time used{};
};

struct HistoryBudget::State {
    State(std::size_t all, std::size_t one, const core::MemoryAccount* account)
        : total(all), each(one), leave(account != nullptr ? account->budget() / 4 : 0),
          share(account != nullptr ? account->open(core::MemoryUse::Histories)
                                   : core::MemoryAccount::Share()) {}

    void count() { share.set(taken(false) + taken(true)); }

    /// Those that have rested longest go first.
    void give_back(std::size_t bytes, Time now) {
        const std::size_t idle = taken(false);
        make_room(idle - std::min(idle, bytes), now);
        count();
    }

    std::size_t taken(bool in_use) const {
        std::size_t sum = 0;
        for (const Entry* entry : entries)
            sum += entry->in_use == in_use ? entry->bytes : 0;
        return sum;
    }

    /// Those not in use get down to `room` together.
    void make_room(std::size_t room, Time now) {
        std::vector<Entry*> idle;
        for (Entry* entry : entries)
            if (!entry->in_use && entry->bytes > 0)
                idle.push_back(entry);
        const auto used_before = [](const Entry* a, const Entry* b) { return a->used < b->used; };
        std::sort(idle.begin(), idle.end(), used_before);
        std::size_t sum = taken(false);
        std::size_t left = idle.size();
        const auto shrink = [&](Entry& entry, std::size_t bytes) {
            sum -= entry.bytes;
            entry.bytes = entry.give_way(bytes);
            sum += entry.bytes;
            left -= bytes == 0 ? 1 : 0;
        };
        for (Entry* entry : idle)
            if (sum > room && now - entry->used >= limits::history_rest)
                shrink(*entry, 0);
        const std::size_t even = left == 0 ? 0 : room / left;
        for (Entry* entry : idle)
            if (sum > room && even > 0 && entry->bytes > even)
                shrink(*entry, even);
        for (Entry* entry : idle)
            if (sum > room && entry->bytes > 0)
                shrink(*entry, 0);
    }

    const std::size_t total;
    const std::size_t each;
    const std::size_t leave; ///< free of the account, for what cannot do without
    mutable std::mutex mutex;
    std::list<Entry*> entries;
    core::MemoryAccount::Share share; ///< of all
};

HistoryBudget::HistoryBudget(std::size_t total,
                             std::size_t each,
                             const core::MemoryAccount* account)
    : state_(std::make_shared<State>(total, each, account)) {
    if (account != nullptr)
        asked_ =
            account->on_need(core::ReclaimOrder::Histories, [state = state_](std::size_t bytes) {
                const std::lock_guard lock(state->mutex);
                state->give_back(bytes, Time::max());
            });
}

std::size_t HistoryBudget::bytes() const {
    const std::lock_guard lock(state_->mutex);
    return state_->taken(false) + state_->taken(true);
}

HistoryBudget::Permit::Permit(const HistoryBudget& budget, GiveWay give_way)
    : state_(budget.state_), entry_(new Entry{std::move(give_way)}) {
    const std::lock_guard lock(state_->mutex);
    state_->entries.push_back(entry_.get());
}

HistoryBudget::Permit::~Permit() {
    const std::lock_guard lock(state_->mutex);
    state_->entries.remove(entry_.get());
    state_->count();
}

// A history takes at most half of the unused memory, so that something is left for those begun meanwhile.
std::size_t HistoryBudget::Permit::begin(Time now) {
    const std::lock_guard lock(state_->mutex);
    const std::size_t free = state_->total - state_->taken(true);
    entry_->bytes = std::min(state_->each, free / 2);
    entry_->in_use = true;
    entry_->used = now;
    state_->make_room(free - entry_->bytes, now);
    // What the account does not have this one does without.
    const std::size_t others = state_->taken(false) + state_->taken(true) - entry_->bytes;
    state_->share.shrink_to(others);
    while (entry_->bytes > 0 &&
           !state_->share.grow_within_free(others + entry_->bytes, state_->leave))
        entry_->bytes = entry_->bytes > least_history ? entry_->bytes / 2 : 0;
    return entry_->bytes;
}

void HistoryBudget::Permit::end(std::size_t bytes) {
    const std::lock_guard lock(state_->mutex);
    entry_->bytes = bytes;
    entry_->in_use = false;
    state_->count();
}

void HistoryBudget::Permit::clear() {
    const std::lock_guard lock(state_->mutex);
    entry_->bytes = entry_->give_way(0);
    state_->count();
}

} // namespace wakesurf::server
