#include "core/dataset/brick_cache.hpp"

#include "core/base/blocking_wait.hpp"
#include "core/base/event_count.hpp"
#include "core/dataset/brick_table.hpp"
#include "core/dataset/slab.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <utility>

namespace wakesurf::core {

namespace {

// A particle's stages lie in up to eight bricks, of which cubics read four time-steps: two particles at once.
// With 128 bricks a tornado of 320^3 nodes had no room for its stream and path surfaces in 128 MiB.
constexpr std::size_t fewest_slots = 64;

// Bricks are taken from memory in pieces large enough for huge pages.
constexpr std::size_t most_slots_a_slab = 64;

// Limits the fields at time-steps that have bricks in memory: cubic sampling of velocity holds four for each
// of two callers, and a scalar beside it.
constexpr std::size_t most_tables = 12;

// Keeps 1/8 of the account free for others.
constexpr std::size_t left_free = 8;

// In rounds of misses: a few intervals of a surface that is played.
constexpr BrickTable::Age recent_rounds = 8;

// Wide loads of the last row go beyond it.
constexpr std::size_t padding = 64;

std::size_t slot_bytes(const BrickLayout& layout) {
    return (layout.nodes_per_brick() * 3 * sizeof(float) + padding + 63) / 64 * 64;
}

} // namespace

std::size_t BrickCache::smallest_budget(const BrickLayout& layout) {
    return std::min(fewest_slots, 4 * layout.count()) * slot_bytes(layout) +
           most_tables * BrickTable::bytes(layout.count());
}

struct BrickCache::State {
    /// The memory of one brick.
    struct Slot {
        float* memory = nullptr;
        BrickTable* table = nullptr; ///< null: free
        std::size_t brick = 0;
        bool loading = false;
    };

    /// A brick that is being read, and those that wait for it.
    struct Load {
        std::optional<Error> error;
        bool done = false;
    };

    /// A field at a time-step.
    struct StepName {
        std::size_t step, field;

        auto operator<=>(const StepName&) const = default;
    };

    struct Step {
        std::shared_ptr<BrickTable> table;
        std::size_t bricks = 0; ///< in memory or on their way
        std::size_t loading = 0;
        std::uint64_t last_use = 0; ///< by the use clock; 0: never
    };

    State(const BrickSource& its_source, Options options)
        : source(its_source), layout(its_source.layout()), bytes_a_slot(slot_bytes(layout)),
          zero_brick(bytes_a_slot), budget(std::max(options.budget_bytes, smallest_budget(layout))),
          account(std::move(options.account)), listener(std::move(options.changed)) {
        if (account) {
            budget = std::max(account->budget(), smallest_budget(layout));
            share = account->open(MemoryUse::TimeSteps);
        }
        slots_a_slab = std::clamp<std::size_t>(
            std::min(budget / bytes_a_slot / 16, 4 * layout.count()), 1, most_slots_a_slab);
    }

    const BrickSource& source;
    const BrickLayout& layout;
    std::size_t bytes_a_slot;
    Slab zero_brick;
    std::size_t budget;
    std::optional<MemoryAccount> account;
    MemoryAccount::Share share;
    std::size_t slots_a_slab;

    mutable std::mutex mutex;
    EventCount changed; ///< a brick has come, or room has
    std::vector<Slab> slabs;
    std::vector<Slot> slots;
    std::vector<std::size_t> free;
    RetiredSlots retired;
    std::size_t most_bytes = 0;
    std::map<StepName, Step> steps; ///< those with bricks in memory, or with a table in use
    std::map<BrickName, std::shared_ptr<Load>> loads;
    std::atomic<BrickTable::Age> age{1};
    std::atomic<std::uint64_t> reads{0}, waits{0}, rounds{0};
    std::stop_source closing;
    std::shared_ptr<void> reclaim_registration;
    std::function<void()> listener;
    std::atomic<bool> counts_changed{false}; ///< since the listener was called

    void notify_listener() {
        if (listener && counts_changed.exchange(false))
            listener();
    }

    std::uint64_t use_clock = 0;

    Step& step_of(const StepName& name) {
        Step& step = steps[name];
        if (!step.table) {
            step.table = std::make_shared<BrickTable>(name.step, layout.count(), name.field);
            forget_steps();
        }
        return step;
    }

    /// Forgets unused steps: the empty ones, and as long as there are too many the least recently used one
    /// with all its bricks, but none of which a brick is on its way.
    void forget_steps() {
        const auto held = [](const Step& step) { return step.table.use_count() > 1; };
        const auto erase_empty = [&] {
            std::erase_if(steps, [&](const auto& each) {
                return each.second.bricks == 0 && each.second.last_use != 0 && !held(each.second);
            });
        };
        erase_empty();
        while (steps.size() > most_tables) {
            const BrickTable* oldest = nullptr;
            std::uint64_t earliest = use_clock + 1;
            for (const auto& [index, step] : steps)
                if (step.last_use != 0 && step.last_use < earliest && step.loading == 0 &&
                    !held(step)) {
                    oldest = step.table.get();
                    earliest = step.last_use;
                }
            if (oldest == nullptr)
                return;
            retired.next_epoch();
            for (std::size_t i = 0; i < slots.size(); ++i)
                if (slots[i].table == oldest)
                    remove(i);
            retired.reclaim(free);
            erase_empty();
        }
    }

    static StepName name_of(const BrickTable& table) { return {table.step(), table.field()}; }

    /// Removes the brick; its memory is free once no reader can still see it.
    void remove(std::size_t index) {
        Slot& slot = slots[index];
        slot.table->put(slot.brick, nullptr);
        --steps.at(name_of(*slot.table)).bricks;
        counts_changed = true;
        slot.table = nullptr;
        retired.retire(index);
    }

    std::size_t table_bytes() const {
        return std::max(steps.size(), most_tables) * BrickTable::bytes(layout.count());
    }

    std::size_t bytes() const { return slots.size() * bytes_a_slot + table_bytes(); }

    bool grow() {
        const std::size_t room = (budget - std::min(budget, bytes())) / bytes_a_slot;
        const std::size_t more = std::min(room, slots_a_slab);
        if (more == 0)
            return false;
        const std::size_t then = bytes() + more * bytes_a_slot;
        if (account && !share.grow_within_free(then, account->budget() / left_free)) {
            if (slots.size() >= fewest_slots) // those are always there
                return false;
            share.set(then);
        }
        slabs.emplace_back(more * bytes_a_slot);
        auto* memory = reinterpret_cast<float*>(slabs.back().bytes().data());
        for (std::size_t i = 0; i < more; ++i) {
            free.push_back(slots.size());
            slots.push_back({memory + i * (bytes_a_slot / sizeof(float)), nullptr, 0, false});
        }
        return true;
    }

    /// Releases unread memory, the slab that was taken last first. Returns the bytes.
    std::size_t reclaim(std::size_t wanted) {
        std::size_t reclaimed = 0;
        const std::scoped_lock lock(mutex);
        while (reclaimed < wanted && slots.size() >= fewest_slots + slots_a_slab) {
            const std::size_t its = slabs.back().bytes().size() / bytes_a_slot;
            const std::size_t first = slots.size() - its;
            const auto of_slab = [&](std::size_t slot) { return slot >= first; };
            if (retired.being_read() ||
                std::any_of(slots.begin() + static_cast<std::ptrdiff_t>(first), slots.end(),
                            [](const Slot& slot) { return slot.loading; }))
                break;
            retired.next_epoch();
            for (std::size_t i = first; i < slots.size(); ++i)
                if (slots[i].table != nullptr)
                    remove(i);
            retired.reclaim(free);
            std::erase_if(free, of_slab);
            slots.resize(first);
            slabs.pop_back();
            reclaimed += its * bytes_a_slot;
            share.shrink_to(bytes());
        }
        return reclaimed;
    }

    /// Makes room of the bricks not used for longest. @param keep  if given, those used since then stay
    void evict(std::size_t count, std::optional<BrickTable::Age> keep) {
        const BrickTable::Age now = age;
        const auto idle = [&](std::size_t i) {
            return static_cast<BrickTable::Age>(now - slots[i].table->used(slots[i].brick));
        };
        std::vector<std::pair<BrickTable::Age, std::size_t>> candidates;
        for (std::size_t i = 0; i < slots.size(); ++i)
            if (slots[i].table && !slots[i].loading)
                if (!keep || idle(i) > static_cast<BrickTable::Age>(now - *keep))
                    candidates.emplace_back(idle(i), i);
        const std::size_t most = std::min(count, candidates.size());
        std::nth_element(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(most),
                         candidates.end(), std::greater<>());
        retired.next_epoch();
        for (std::size_t i = 0; i < most; ++i)
            remove(candidates[i].second);
        retired.reclaim(free);
    }

    struct Begun {
        std::size_t slot;
        std::shared_ptr<Load> load;
    };

    /// The result of start().
    struct Batch {
        std::vector<std::shared_ptr<Load>> waiting; ///< for these
        std::vector<BrickRead> reads;               ///< to be started without the lock
        std::vector<Begun> begun;                   ///< one a read
        bool all = false;                           ///< there was room for all
    };

    /// Takes room for what neither is there nor on its way.
    Batch start(std::span<const BrickName> bricks, std::optional<BrickTable::Age> keep) {
        Batch batch;
        std::vector<BrickName> wanted;
        for (const BrickName& name : bricks)
            if (const auto under_way = loads.find(name); under_way != loads.end())
                batch.waiting.push_back(under_way->second);
            else if (BrickTable& table = *step_of({name.step, name.field}).table;
                     table.at(name.brick) == nullptr)
                wanted.push_back(name);
            else
                table.use(name.brick, age);
        while (free.size() < wanted.size() && grow())
            ;
        if (free.size() < wanted.size())
            evict(wanted.size() - free.size(), keep);
        most_bytes = std::max(most_bytes, bytes());
        batch.all = free.size() >= wanted.size();
        wanted.resize(std::min(wanted.size(), free.size()));
        for (const BrickName& name : wanted) {
            Slot& slot = slots[free.back()];
            Step& step = step_of({name.step, name.field});
            step.last_use = ++use_clock;
            ++step.bricks;
            ++step.loading;
            counts_changed = true;
            slot.table = step.table.get();
            slot.brick = name.brick;
            slot.loading = true;
            const auto load = std::make_shared<Load>();
            loads.emplace(name, load);
            batch.waiting.push_back(load);
            batch.reads.push_back(
                {name.step,
                 name.brick,
                 {slot.memory, layout.nodes_per_brick() * (name.field == 0 ? 3 : 1)},
                 name.field});
            batch.begun.push_back({free.back(), load});
            free.pop_back();
        }
        return batch;
    }

    /// Reads without the lock, because a source may answer at once.
    void read(const std::shared_ptr<State>& self, Batch& batch) {
        if (batch.reads.empty())
            return;
        reads += batch.reads.size();
        source.read(std::move(batch.reads), closing.get_token(),
                    [self, begun = std::move(batch.begun)](std::size_t i, Result<void> outcome) {
                        self->finish(begun[i], std::move(outcome));
                    });
    }

    /// Takes no room from bricks used in recent rounds.
    void ahead(const std::shared_ptr<State>& self, std::span<const BrickName> bricks) {
        Batch batch;
        {
            const std::scoped_lock lock(mutex);
            batch = start(bricks, static_cast<BrickTable::Age>(age - recent_rounds));
        }
        read(self, batch);
        notify_listener();
    }

    void finish(const Begun& of, Result<void> outcome) {
        {
            const std::scoped_lock lock(mutex);
            Slot& slot = slots[of.slot];
            loads.erase({slot.table->step(), slot.brick, slot.table->field()});
            slot.loading = false;
            Step& step = steps.at(name_of(*slot.table));
            --step.loading;
            counts_changed = true;
            of.load->done = true;
            if (outcome) {
                slot.table->use(slot.brick, age);
                slot.table->put(slot.brick, slot.memory);
            } else {
                of.load->error = outcome.error();
                --step.bricks;
                slot.table = nullptr;
                free.push_back(of.slot);
            }
        }
        changed.notify_all();
        notify_listener();
    }
};

BrickCache::BrickCache(const BrickSource& source, Options options)
    : state_(std::make_shared<State>(source, std::move(options))) {
    if (state_->account)
        state_->reclaim_registration = state_->account->on_need(
            ReclaimOrder::TimeSteps, [state = state_.get()](std::size_t bytes) {
                state->reclaim(bytes);
                state->notify_listener();
            });
}

BrickCache::~BrickCache() {
    state_->reclaim_registration.reset();
    state_->closing.request_stop();
    std::unique_lock lock(state_->mutex);
    for (auto seen = state_->changed.notifications(); !state_->loads.empty();
         seen = state_->changed.notifications())
        state_->changed.wait(lock, seen);
}

const BrickLayout& BrickCache::layout() const {
    return state_->layout;
}

std::shared_ptr<const BrickTable> BrickCache::table(std::size_t step, std::size_t field) {
    std::shared_ptr<const BrickTable> table;
    {
        const std::scoped_lock lock(state_->mutex);
        State::Step& found = state_->step_of({step, field});
        found.last_use = ++state_->use_clock;
        table = found.table;
    }
    state_->notify_listener(); // another may have made room for it
    return table;
}

const float* BrickCache::zeros() const {
    return reinterpret_cast<const float*>(state_->zero_brick.bytes().data());
}

BrickTable::Age BrickCache::age() const {
    return state_->age;
}

BrickCache::Reading::Reading(BrickCache& cache) : cache_(cache) {
    const std::scoped_lock lock(cache_.state_->mutex);
    began_ = cache_.state_->retired.begin_reading();
}

BrickCache::Reading::~Reading() {
    State& state = *cache_.state_;
    bool room = false;
    {
        const std::scoped_lock lock(state.mutex);
        state.retired.end_reading(began_);
        const std::size_t before = state.free.size();
        state.retired.reclaim(state.free);
        room = state.free.size() > before;
    }
    if (room)
        state.changed.notify_all();
}

std::size_t BrickCache::capacity() const {
    const std::scoped_lock lock(state_->mutex);
    const std::size_t slots =
        (state_->budget - std::min(state_->budget, state_->table_bytes())) / state_->bytes_a_slot;
    return std::max(slots, fewest_slots);
}

std::size_t BrickCache::most_at_once() const {
    return capacity() / 2;
}

Result<void> BrickCache::fetch(std::span<const BrickName> bricks,
                               const std::stop_token& stop,
                               std::span<const BrickName> soon) {
    State& state = *state_;
    const BlockingWait blocked;
    const std::stop_callback wake(stop, [&] { state.changed.notify_all(); });
    ++state.age;
    ++state.waits;
    bool requested = false;
    std::vector<std::shared_ptr<State::Load>> waiting;
    for (bool all = false; !all;) {
        State::Batch batch;
        const auto seen = state.changed.notifications();
        {
            const std::scoped_lock lock(state.mutex);
            batch = state.start(bricks, std::nullopt);
        }
        waiting.insert(waiting.end(), batch.waiting.begin(), batch.waiting.end());
        all = batch.all;
        const bool none = batch.reads.empty();
        state.rounds += none || std::exchange(requested, true) ? 0 : 1;
        state.read(state_, batch);
        state.notify_listener();
        if (!all && none && !stop.stop_requested())
            state.changed.wait(seen);
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "waiting for bricks was cancelled");
    }
    state.ahead(state_, soon);
    std::unique_lock lock(state.mutex);
    const auto done = [&] {
        return std::all_of(waiting.begin(), waiting.end(),
                           [](const auto& load) { return load->done; });
    };
    for (auto seen = state.changed.notifications(); !done() && !stop.stop_requested();
         seen = state.changed.notifications())
        state.changed.wait(lock, seen);
    if (!done())
        return fail(Error::Code::Cancelled, "waiting for bricks was cancelled");
    for (const auto& load : waiting)
        if (load->error)
            return tl::unexpected(*load->error);
    return {};
}

void BrickCache::prefetch(std::span<const BrickName> bricks) {
    ++state_->age;
    state_->ahead(state_, bricks);
}

std::vector<std::uint32_t> BrickCache::used(std::size_t step, BrickTable::Age since) const {
    const std::scoped_lock lock(state_->mutex);
    std::vector<std::uint32_t> bricks;
    const BrickTable::Age now = state_->age;
    for (const State::Slot& slot : state_->slots)
        if (slot.table && !slot.loading && slot.table->step() == step && slot.table->field() == 0 &&
            static_cast<BrickTable::Age>(now - slot.table->used(slot.brick)) <=
                static_cast<BrickTable::Age>(now - since))
            bricks.push_back(static_cast<std::uint32_t>(slot.brick));
    std::sort(bricks.begin(), bricks.end());
    return bricks;
}

std::map<std::size_t, BrickCache::Held> BrickCache::held() const {
    const std::scoped_lock lock(state_->mutex);
    std::map<std::size_t, Held> held;
    for (const auto& [name, step] : state_->steps)
        if (name.field == 0 && step.bricks > 0)
            held[name.step] = {step.bricks - step.loading, step.loading};
    return held;
}

BrickCache::Status BrickCache::status() const {
    const std::scoped_lock lock(state_->mutex);
    return {state_->bytes(), state_->most_bytes, state_->budget,
            state_->reads,   state_->waits,      state_->rounds};
}

} // namespace wakesurf::core
