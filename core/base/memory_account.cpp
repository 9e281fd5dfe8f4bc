#include "core/base/memory_account.hpp"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstdint>
#include <list>
#include <mutex>
#include <utility>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr std::array<std::string_view, memory_uses> names{
    "timeSteps", "meshes",    "builds",  "surfaces", "rings", "histories",
    "downloads", "importers", "records", "messages", "other"};

constexpr const char* refusal_hint = "ask for fewer quads or a larger separation, close surfaces "
                                     "that no one is viewing, or start the server "
                                     "with more --memory";

std::size_t index(MemoryUse use) {
    return static_cast<std::size_t>(use);
}

std::string mebibytes(std::size_t bytes) {
    const std::size_t tenths = (bytes / 1024 * 10 + 1023) / 1024;
    return std::to_string(tenths / 10) + (tenths < 1000 ? "." + std::to_string(tenths % 10) : "") +
           " MiB";
}

} // namespace

std::string_view name_of(MemoryUse use) {
    return names.at(index(use));
}

struct MemoryAccount::Giver {
    GiveBack order;
    std::function<void(std::size_t)> give_back;
    std::mutex at_work; ///< held while it is asked
    bool ended = false;
};

struct MemoryAccount::State {
    explicit State(std::size_t all) : budget(all) {}

    const std::size_t budget;
    mutable std::mutex mutex;
    std::condition_variable_any given_back;
    std::size_t used = 0;
    std::array<std::size_t, memory_uses> by_use{};
    std::list<std::shared_ptr<Giver>> givers; ///< in their order
    std::size_t refused = 0;
    std::function<std::size_t()> resident;
    std::size_t program = 0; ///< bytes beyond the shares at the first look: they stay
    std::size_t unseen = 0;  ///< bytes taken since the last look
    std::mutex looking;      ///< guards `resident`; held before `mutex`

    /// Without the account's lock: asking the system takes some time, in which the kernel may set this thread aside. One at a time, so that
    /// an older look does not replace a newer one.
    void look() {
        const std::unique_lock one_at_a_time(looking, std::try_to_lock);
        if (!one_at_a_time || !resident)
            return;
        const std::size_t seen = resident();
        const std::lock_guard lock(mutex);
        unseen = 0;
        std::size_t& other = by_use[index(MemoryUse::Other)];
        const std::size_t here = used - other - by_use[index(MemoryUse::Importers)];
        used -= other;
        // What is told but not touched yet hides as much that is there.
        other = std::max(seen - std::min(seen, here), program);
        used += other;
    }

    bool fits(std::size_t more) const { return used <= budget && more <= budget - used; }

    /// With the lock.
    void change(MemoryUse use, std::size_t from, std::size_t to) {
        by_use[index(use)] += to - from; // modulo 2^64: right for both directions
        used += to - from;
    }

    bool try_change(MemoryUse use, std::size_t from, std::size_t to, std::size_t leave) {
        std::unique_lock lock(mutex);
        const std::size_t more = to - from;
        unseen += std::min(more, budget);
        if (unseen > budget / 256) {
            lock.unlock();
            look();
            lock.lock();
        }
        if (!fits(more > SIZE_MAX - leave ? SIZE_MAX : more + leave))
            return false;
        change(use, from, to);
        return true;
    }

    /// Until `more` fits. @param little  small work wants it
    bool ask(std::size_t more, bool little = false) {
        std::vector<std::shared_ptr<Giver>> all;
        {
            const std::lock_guard lock(mutex);
            all.assign(givers.begin(), givers.end());
        }
        for (const auto& giver : all) {
            std::size_t wanted = 0;
            look();
            {
                const std::lock_guard lock(mutex);
                if (fits(more))
                    return true;
                wanted = more > SIZE_MAX - used ? SIZE_MAX : more + used - budget;
            }
            const bool build = giver->order == GiveBack::Builds;
            if (build && !little)
                break;
            const std::lock_guard one_at_a_time(giver->at_work);
            if (!giver->ended)
                giver->give_back(wanted);
            if (build) // it takes a moment to end
                break;
        }
        look();
        const std::lock_guard lock(mutex);
        return fits(more);
    }
};

MemoryAccount::MemoryAccount(std::size_t budget) : state_(std::make_shared<State>(budget)) {}

MemoryAccount::Share::~Share() {
    shrink_to(0);
}

MemoryAccount::Share::Share(Share&& other) noexcept
    : state_(std::move(other.state_)), use_(other.use_), bytes_(std::exchange(other.bytes_, 0)) {}

MemoryAccount::Share& MemoryAccount::Share::operator=(Share&& other) noexcept {
    if (this == &other)
        return *this;
    shrink_to(0);
    state_ = std::move(other.state_);
    use_ = other.use_;
    bytes_ = std::exchange(other.bytes_, 0);
    return *this;
}

bool MemoryAccount::Share::grow_within_free(std::size_t bytes, std::size_t leave) {
    if (bytes > bytes_ && state_ && !state_->try_change(use_, bytes_, bytes, leave))
        return false;
    bytes_ = std::max(bytes_, bytes);
    return true;
}

bool MemoryAccount::Share::grow_to(std::size_t bytes) {
    if (grow_within_free(bytes))
        return true;
    const std::size_t more = bytes - bytes_;
    // What another took of it meanwhile is asked for once more.
    for (int i = 0; i < 2; ++i)
        if (state_->ask(more) && grow_within_free(bytes))
            return true;
    const std::lock_guard lock(state_->mutex);
    ++state_->refused;
    return false;
}

bool MemoryAccount::Share::grow_to(std::size_t bytes,
                                   const std::stop_token& stop,
                                   std::chrono::milliseconds patience,
                                   std::size_t leave) {
    if (grow_within_free(bytes, leave))
        return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    const std::size_t grown = bytes - bytes_;
    const std::size_t more = grown > SIZE_MAX - leave ? SIZE_MAX : grown + leave;
    if (more > state_->budget) {
        const std::lock_guard lock(state_->mutex);
        ++state_->refused;
        return false;
    }
    for (;;) {
        state_->ask(more, leave == 0 && bytes <= small_of(state_->budget));
        if (grow_within_free(bytes, leave))
            return true;
        std::unique_lock lock(state_->mutex);
        if (stop.stop_requested() || std::chrono::steady_clock::now() >= end) {
            ++state_->refused;
            return false;
        }
        // Asked again now and then: others may have come to hold something that can be given back.
        const auto look =
            std::min(end, std::chrono::steady_clock::now() + std::chrono::milliseconds(50));
        state_->given_back.wait_until(lock, stop, look, [&] { return state_->fits(more); });
    }
}

void MemoryAccount::Share::shrink_to(std::size_t bytes) {
    if (bytes < bytes_)
        set(bytes);
}

void MemoryAccount::Share::set(std::size_t bytes) {
    if (state_) {
        {
            const std::lock_guard lock(state_->mutex);
            state_->change(use_, bytes_, bytes);
        }
        if (bytes < bytes_) // without the lock: those who wait take it
            state_->given_back.notify_all();
    }
    bytes_ = bytes;
}

void MemoryAccount::Share::join(Share&& other) {
    if (state_ && state_ == other.state_) {
        const std::lock_guard lock(state_->mutex);
        state_->by_use[index(other.use_)] -= other.bytes_;
        state_->by_use[index(use_)] += other.bytes_;
    } else {
        other.shrink_to(0);
    }
    bytes_ += std::exchange(other.bytes_, 0);
}

void MemoryAccount::watch(std::function<std::size_t()> resident) const {
    {
        const std::lock_guard lock(state_->looking);
        state_->resident = std::move(resident);
    }
    state_->look();
    const std::lock_guard lock(state_->mutex);
    state_->program = state_->by_use[index(MemoryUse::Other)];
}

void MemoryAccount::look() const {
    state_->look();
}

MemoryAccount::Share MemoryAccount::open(MemoryUse use) const {
    return {state_, use};
}

std::shared_ptr<void>
MemoryAccount::on_need(GiveBack order, std::function<void(std::size_t wanted)> give_back) const {
    auto giver = std::make_shared<Giver>();
    giver->order = order;
    giver->give_back = std::move(give_back);
    {
        const std::lock_guard lock(state_->mutex);
        const auto later = std::find_if(state_->givers.begin(), state_->givers.end(),
                                        [&](const auto& each) { return each->order > order; });
        state_->givers.insert(later, giver);
    }
    return {giver.get(), [giver, state = std::weak_ptr(state_)](Giver*) {
                {
                    const std::lock_guard wait(giver->at_work);
                    giver->ended = true;
                }
                if (const auto there = state.lock()) {
                    const std::lock_guard lock(there->mutex);
                    there->givers.remove(giver);
                }
            }};
}

std::size_t MemoryAccount::budget() const {
    return state_->budget;
}

std::size_t MemoryAccount::used() const {
    const std::lock_guard lock(state_->mutex);
    return state_->used;
}

std::size_t MemoryAccount::used(MemoryUse use) const {
    const std::lock_guard lock(state_->mutex);
    return state_->by_use[index(use)];
}

std::size_t MemoryAccount::free() const {
    const std::lock_guard lock(state_->mutex);
    return state_->budget - std::min(state_->budget, state_->used);
}

std::size_t MemoryAccount::refused() const {
    const std::lock_guard lock(state_->mutex);
    return state_->refused;
}

void MemoryAccount::make_room(std::size_t bytes) const {
    state_->ask(bytes);
}

Error MemoryAccount::refusal(std::string_view what, std::size_t bytes) const {
    return {Error::Code::OverLimit,
            std::string(what) + " needs " + mebibytes(bytes) + " of memory, but of the " +
                mebibytes(budget()) + " of --memory only " + mebibytes(free()) + " are free",
            refusal_hint,
            {},
            budget()};
}

Error MemoryAccount::gave_way(std::string_view what, std::size_t bytes) const {
    return {Error::Code::OverLimit,
            std::string(what) + " was stopped when it held " + mebibytes(bytes) +
                " of memory: all of the " + mebibytes(budget()) +
                " of --memory were in use, and smaller surfaces take precedence",
            refusal_hint,
            {},
            budget()};
}

} // namespace wakesurf::core
