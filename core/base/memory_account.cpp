#include "core/base/memory_account.hpp"

#include "core/base/event_count.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <list>
#include <mutex>
#include <utility>
#include <vector>

namespace wakesurf::core {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<std::string_view, memory_uses> names{
    "timeSteps", "meshes",    "builds",  "surfaces", "rings", "histories",
    "downloads", "importers", "records", "messages", "other"};

constexpr std::chrono::milliseconds retry_interval{50};

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

struct MemoryAccount::Holder {
    ReclaimOrder order;
    std::function<void(std::size_t)> reclaim;
    std::mutex at_work; ///< held while it is asked
    bool ended = false;
};

/// Counting takes no lock: threads that answer clients would wait for threads of low priority that hold it.
/// Sums are taken modulo 2^64, which is right for both directions.
struct MemoryAccount::State {
    explicit State(std::size_t all) : budget(all) {}

    const std::size_t budget;
    std::atomic<std::size_t> shares{0}; ///< all bytes of all shares
    std::array<std::atomic<std::size_t>, memory_uses> by_use{};
    std::atomic<std::size_t> refused{0};
    std::atomic<std::size_t> unseen{0}; ///< bytes taken since the last measurement
    EventCount released;
    std::mutex asking;                          ///< guards `holders`
    std::list<std::shared_ptr<Holder>> holders; ///< in their order
    std::function<std::size_t()> resident;
    std::atomic<std::uint64_t> measurements{0};
    /// KiB beyond the shares in the low bits, and above them the number of the measurement that found them.
    std::atomic<std::uint64_t> seen{0};
    std::atomic<std::size_t> program{
        0}; ///< bytes beyond the shares at the first measurement: they stay

    static constexpr unsigned kibibyte_bits = 36; // 64 TiB
    static constexpr std::uint64_t most_kibibytes = (std::uint64_t{1} << kibibyte_bits) - 1;

    std::atomic<std::size_t>& of(MemoryUse use) { return by_use[index(use)]; }

    /// Bytes the process holds beyond its shares.
    std::size_t other() const { return static_cast<std::size_t>(seen & most_kibibytes) * 1024; }

    std::size_t used() const { return shares + other(); }

    /// Several threads may measure at a time, so that a preempted one does not block the others. The result
    /// of the measurement that began last stays.
    void measure() {
        if (!resident)
            return;
        unseen = 0;
        const std::uint64_t number = ++measurements;
        const std::size_t held = resident();
        const std::size_t importers = of(MemoryUse::Importers), all = shares;
        const std::size_t here = all - std::min(all, importers);
        // Memory that is reported but not touched yet hides as much that is resident.
        const std::size_t beyond = std::max(held - std::min(held, here), program.load());
        const std::uint64_t kibibytes =
            std::min(beyond / 1024 + (beyond % 1024 != 0), most_kibibytes);
        const std::uint64_t mine = number << kibibyte_bits | kibibytes;
        std::uint64_t newest = seen;
        do {
            // Numbers wrap around: their distance shows which measurement began first.
            if (static_cast<std::int64_t>((newest & ~most_kibibytes) - (mine & ~most_kibibytes)) >
                0)
                return;
        } while (!seen.compare_exchange_weak(newest, mine));
    }

    bool fits(std::size_t more, std::size_t beside) const {
        return beside <= budget && more <= budget - beside;
    }

    bool fits(std::size_t more) const { return fits(more, used()); }

    /// Sleeps until `more` fits, or the time is over. `stop` notifies as well.
    void sleep(std::size_t more, const std::stop_token& stop, Clock::time_point until) {
        for (;;) {
            const auto notified = released.notifications();
            const auto now = Clock::now();
            if (fits(more) || stop.stop_requested() || now >= until)
                return;
            released.wait(notified, until - now);
        }
    }

    void change(MemoryUse use, std::size_t from, std::size_t to) {
        shares += to - from;
        of(use) += to - from;
    }

    bool try_change(MemoryUse use, std::size_t from, std::size_t to, std::size_t leave) {
        const std::size_t more = to - from;
        const std::size_t newly = std::min(more, budget);
        if (unseen.fetch_add(newly) + newly > budget / 256)
            measure();
        const std::size_t wanted = more > SIZE_MAX - leave ? SIZE_MAX : more + leave;
        std::size_t before = shares;
        do {
            if (!fits(wanted, before + other()))
                return false;
        } while (!shares.compare_exchange_weak(before, before + more));
        of(use) += more;
        return true;
    }

    /// Asks others to give memory back until `more` fits.
    bool ask(std::size_t more, bool little = false) {
        std::vector<std::shared_ptr<Holder>> all;
        {
            const std::lock_guard lock(asking);
            all.assign(holders.begin(), holders.end());
        }
        for (const auto& holder : all) {
            measure();
            const std::size_t now = used();
            if (fits(more, now))
                return true;
            const bool build = holder->order == ReclaimOrder::Builds;
            if (build && !little)
                break;
            const std::lock_guard one_at_a_time(holder->at_work);
            if (!holder->ended)
                holder->reclaim(more > SIZE_MAX - now ? SIZE_MAX : more + now - budget);
            if (build) // it takes a moment to end
                break;
        }
        measure();
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
    // Memory that another thread took meanwhile is asked for once more.
    for (int i = 0; i < 2; ++i)
        if (state_->ask(more) && grow_within_free(bytes))
            return true;
    ++state_->refused;
    return false;
}

bool MemoryAccount::Share::grow_to(std::size_t bytes,
                                   const std::stop_token& stop,
                                   std::chrono::milliseconds patience,
                                   std::size_t leave) {
    if (grow_within_free(bytes, leave))
        return true;
    const auto end = Clock::now() + patience;
    const std::size_t grown = bytes - bytes_;
    const std::size_t more = grown > SIZE_MAX - leave ? SIZE_MAX : grown + leave;
    if (more > state_->budget) {
        ++state_->refused;
        return false;
    }
    const std::stop_callback wake(stop, [this] { state_->released.notify_all(); });
    for (;;) {
        state_->ask(more, leave == 0 && bytes <= small_of(state_->budget));
        if (grow_within_free(bytes, leave))
            return true;
        const auto now = Clock::now();
        if (stop.stop_requested() || now >= end) {
            ++state_->refused;
            return false;
        }
        // Asked again now and then: others may have come to hold something that can be reclaimed.
        state_->sleep(more, stop, std::min(end, now + retry_interval));
    }
}

void MemoryAccount::Share::shrink_to(std::size_t bytes) {
    if (bytes < bytes_)
        set(bytes);
}

void MemoryAccount::Share::set(std::size_t bytes) {
    if (state_) {
        state_->change(use_, bytes_, bytes);
        if (bytes < bytes_)
            state_->released.notify_all();
    }
    bytes_ = bytes;
}

void MemoryAccount::Share::join(Share&& other) {
    if (state_ && state_ == other.state_) {
        state_->of(other.use_) -= other.bytes_;
        state_->of(use_) += other.bytes_;
    } else {
        other.shrink_to(0);
    }
    bytes_ += std::exchange(other.bytes_, 0);
}

void MemoryAccount::watch(std::function<std::size_t()> resident) const {
    state_->resident = std::move(resident);
    state_->measure();
    state_->program = used(MemoryUse::Other);
}

void MemoryAccount::measure() const {
    state_->measure();
}

MemoryAccount::Share MemoryAccount::open(MemoryUse use) const {
    return {state_, use};
}

std::shared_ptr<void>
MemoryAccount::on_need(ReclaimOrder order, std::function<void(std::size_t wanted)> reclaim) const {
    auto holder = std::make_shared<Holder>();
    holder->order = order;
    holder->reclaim = std::move(reclaim);
    {
        const std::lock_guard lock(state_->asking);
        const auto later = std::find_if(state_->holders.begin(), state_->holders.end(),
                                        [&](const auto& each) { return each->order > order; });
        state_->holders.insert(later, holder);
    }
    return {holder.get(), [holder, state = std::weak_ptr(state_)](Holder*) {
                {
                    const std::lock_guard wait(holder->at_work);
                    holder->ended = true;
                }
                if (const auto there = state.lock()) {
                    const std::lock_guard lock(there->asking);
                    there->holders.remove(holder);
                }
            }};
}

std::size_t MemoryAccount::budget() const {
    return state_->budget;
}

std::size_t MemoryAccount::used() const {
    return state_->used();
}

std::size_t MemoryAccount::used(MemoryUse use) const {
    return use == MemoryUse::Other ? state_->other() : state_->of(use).load();
}

std::size_t MemoryAccount::free() const {
    const std::size_t used = state_->used();
    return state_->budget - std::min(state_->budget, used);
}

std::size_t MemoryAccount::refused() const {
    return state_->refused;
}

void MemoryAccount::make_room(std::size_t bytes) const {
    state_->ask(bytes);
}

Error MemoryAccount::refusal(std::string_view what, std::size_t bytes) const {
    const std::size_t kept = bytes > small() ? reserved_for_small() : 0;
    const std::size_t for_it = free() - std::min(free(), kept);
    return {Error::Code::OverLimit,
            std::string(what) + " needs " + mebibytes(bytes) + " of memory, but of the " +
                mebibytes(budget()) + " of --memory only " + mebibytes(for_it) + " are free for it",
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
