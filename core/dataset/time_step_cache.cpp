#include "core/dataset/time_step_cache.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace wakesurf::core {

namespace {

using namespace std::chrono_literals;

// A caller that waits for room looks up this often; after so many looks without anything being given
// back it gives up. Short when the callers that wait may between them hold everything (a deadlock).
constexpr auto look = 100ms;
constexpr int looks_when_deadlocked = 3;
constexpr int looks_when_merely_full = 300;

constexpr std::size_t smallest_window = 4;
constexpr std::size_t left_free =
    8; ///< of the account one part in so many, for what begins elsewhere

struct Entry {
    StepState state = StepState::Cold;
    std::shared_ptr<const TimeStep> step; ///< while resident
    std::weak_ptr<const TimeStep> lease;  ///< what is handed out
    std::size_t leases = 0;               ///< handed out and not yet given back
    std::size_t waiters = 0;              ///< acquire() calls waiting for it
    bool in_window = false;               ///< wanted by the last prefetch()
    std::uint64_t last_use = 0;
    std::uint64_t failures = 0;
    Error error;           ///< of the last failure
    std::stop_source load; ///< of the load in flight
};

// How long an acquire() that waits for room may see nothing given back.
class Patience {
  public:
    bool ends(bool full, bool maybe_deadlocked, std::uint64_t progress) {
        if (!full || progress != progress_)
            full_looks_ = deadlocked_looks_ = 0;
        progress_ = progress;
        full_looks_ += full ? 1 : 0;
        deadlocked_looks_ = maybe_deadlocked ? deadlocked_looks_ + 1 : 0;
        return full_looks_ >= looks_when_merely_full || deadlocked_looks_ >= looks_when_deadlocked;
    }

  private:
    std::uint64_t progress_ = 0;
    int full_looks_ = 0;
    int deadlocked_looks_ = 0;
};

struct Job {
    std::size_t index = 0;
    std::stop_token stop;
    std::shared_ptr<const TimeStep> evicted; ///< freed before the load, so that both never coexist
};

} // namespace

// Every change of a step's state happens in a load thread; acquire() only asks and waits. A step's
// memory counts from the moment its load is picked until it is evicted, and only steps that nobody
// holds are evicted: that is what makes the budget hard.
struct TimeStepCache::State {
    struct Window {
        std::mutex mutex;
        std::condition_variable_any changed; ///< a load ended
        std::condition_variable_any work;    ///< something to load, or room for it
        std::vector<Entry> entries;
        std::deque<std::size_t> demanded;   ///< cold steps somebody waits for, oldest first
        std::deque<std::size_t> prefetched; ///< cold steps to load ahead, nearest first
        std::size_t position = 0;           ///< of the last prefetch()
        std::size_t capacity = 0; ///< time-steps the budget holds; with an account: could at most
        std::size_t smallest = 0; ///< that are always there
        std::size_t step_bytes = 0;
        std::optional<MemoryAccount> account;
        MemoryAccount::Share share; ///< of the account: `used`, at least `smallest`
        bool starved = false; ///< the last load had to wait: there was no memory beyond `used`
        std::size_t used = 0; ///< resident and in flight
        std::size_t lent = 0; ///< entries handed out
        std::size_t held = 0; ///< by those whose acquire() waits, together
        std::size_t idle_threads = 0;
        bool closing = false;
        std::uint64_t clock = 0;    ///< order of use
        std::uint64_t progress = 0; ///< counts loads ended and leases given back
        std::uint64_t hits = 0;
        std::uint64_t loads = 0;

        std::shared_ptr<const TimeStep> lend(const std::shared_ptr<Window>& self,
                                             std::size_t index);
        void give_back(std::size_t index);
        void demand(std::size_t index);
        void withdraw(std::size_t index);
        template <class Unwanted>
        void stop_loads(Unwanted unwanted);
        std::size_t room() const;

        bool hungry() const { return starved && !demanded.empty(); }

        bool make_room(std::size_t leave);
        void count();
        std::vector<std::shared_ptr<const TimeStep>> give_back_spare(std::size_t bytes);
        bool may_be_deadlocked() const;
        std::optional<std::size_t> victim(bool spare_window) const;
        std::shared_ptr<const TimeStep> evict(std::size_t index);
        std::optional<Job> pick();
        std::optional<Job> start(std::size_t index, bool spare_window);
        void finish(std::size_t index, Result<std::shared_ptr<const TimeStep>> loaded);
    };

    std::shared_ptr<const TimeStepSource> source;
    std::size_t step_bytes = 0;
    std::size_t budget_bytes = 0;
    std::shared_ptr<Window> window = std::make_shared<Window>();
    std::mutex listener_mutex;
    std::function<void()> listener;
    std::vector<std::jthread> threads;
    std::shared_ptr<void> asked; ///< by others, for memory

    Result<std::shared_ptr<const TimeStep>> load(const Job& job) const;
    void load_until(const std::stop_token& stop);
    void announce();
};

std::shared_ptr<const TimeStep>
TimeStepCache::State::Window::lend(const std::shared_ptr<Window>& self, std::size_t index) {
    Entry& entry = entries[index];
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
            window->give_back(index);
        });
    entry.lease = lease;
    return lease;
}

void TimeStepCache::State::Window::give_back(std::size_t index) {
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

void TimeStepCache::State::Window::demand(std::size_t index) {
    if (entries[index].state == StepState::Cold &&
        std::find(demanded.begin(), demanded.end(), index) == demanded.end())
        demanded.push_back(index);
    if (entries[index].state == StepState::Cold && idle_threads == 0)
        stop_loads([](const Entry& other) { return other.waiters == 0; });
}

template <class Unwanted>
void TimeStepCache::State::Window::stop_loads(Unwanted unwanted) {
    for (Entry& entry : entries)
        if (entry.state == StepState::Loading && unwanted(entry))
            entry.load.request_stop();
}

void TimeStepCache::State::Window::withdraw(std::size_t index) {
    if (--entries[index].waiters == 0)
        std::erase(demanded, index);
}

/// Time-steps there may be as things stand.
std::size_t TimeStepCache::State::Window::room() const {
    return starved ? std::min(capacity, std::max(used, smallest)) : capacity;
}

bool TimeStepCache::State::Window::may_be_deadlocked() const {
    return lent >= room() && lent <= held;
}

/// For one more. Within what is free: others are not asked while the window is locked.
bool TimeStepCache::State::Window::make_room(std::size_t leave) {
    if (used >= capacity)
        return false;
    const bool there =
        !account || used < smallest || share.grow_within_free((used + 1) * step_bytes, leave);
    starved = !there;
    return there;
}

void TimeStepCache::State::Window::count() {
    share.shrink_to(std::max(used, smallest) * step_bytes);
}

/// Beyond the smallest window, and nobody holds them. To be freed without the lock.
std::vector<std::shared_ptr<const TimeStep>>
TimeStepCache::State::Window::give_back_spare(std::size_t bytes) {
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

std::shared_ptr<const TimeStep> TimeStepCache::State::Window::evict(std::size_t index) {
    Entry& entry = entries[index];
    auto step = std::move(entry.step);
    entry.step.reset();
    entry.lease.reset();
    entry.state = StepState::Cold;
    --used;
    return step;
}

// Least recently used outside the window; inside it the farthest from its position.
std::optional<std::size_t> TimeStepCache::State::Window::victim(bool spare_window) const {
    std::optional<std::size_t> best;
    const auto distance = [&](std::size_t i) { return i > position ? i - position : position - i; };
    const auto better = [&](std::size_t a, std::size_t b) {
        if (entries[a].in_window != entries[b].in_window)
            return entries[b].in_window;
        return entries[a].in_window ? distance(a) > distance(b)
                                    : entries[a].last_use < entries[b].last_use;
    };
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        const bool free = entry.state == StepState::Resident && entry.leases == 0 &&
                          entry.waiters == 0 && !(spare_window && entry.in_window);
        if (free && (!best || better(i, *best)))
            best = i;
    }
    return best;
}

std::optional<Job> TimeStepCache::State::Window::pick() {
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

std::optional<Job> TimeStepCache::State::Window::start(std::size_t index, bool spare_window) {
    Job job;
    job.index = index;
    if (!make_room(account ? account->budget() / left_free : 0)) {
        if (const auto out = victim(spare_window))
            job.evicted = evict(*out);
        else if (spare_window || !make_room(0))
            return std::nullopt;
    }
    Entry& entry = entries[index];
    entry.state = StepState::Loading;
    entry.load = std::stop_source();
    job.stop = entry.load.get_token();
    ++used;
    return job;
}

void TimeStepCache::State::Window::finish(std::size_t index,
                                          Result<std::shared_ptr<const TimeStep>> loaded) {
    const std::scoped_lock lock(mutex);
    Entry& entry = entries[index];
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

Result<std::shared_ptr<const TimeStep>> TimeStepCache::State::load(const Job& job) const {
    try {
        return source->load(job.index, job.stop);
    } catch (const std::bad_alloc&) {
        return fail(Error::Code::OverLimit,
                    "there is no memory for time-step " + std::to_string(job.index) + " (" +
                        std::to_string(step_bytes) + " bytes)",
                    "give the cache a smaller --memory");
    } catch (const std::exception& problem) {
        return fail(Error::Code::Io, "time-step " + std::to_string(job.index) +
                                         " could not be loaded: " + problem.what());
    }
}

void TimeStepCache::State::announce() {
    const std::scoped_lock lock(listener_mutex);
    if (listener)
        listener();
}

void TimeStepCache::State::load_until(const std::stop_token& stop) {
    while (true) {
        std::optional<Job> job;
        {
            std::unique_lock lock(window->mutex);
            ++window->idle_threads;
            const auto picked = [&] { return (job = window->pick()).has_value(); };
            while (!job && !stop.stop_requested()) {
                window->work.wait(lock, stop, [&] { return picked() || window->hungry(); });
                if (job || stop.stop_requested())
                    break;
                lock.unlock();
                window->account->make_room(step_bytes); // of others: somebody waits for it
                lock.lock();
                window->work.wait_for(lock, stop, look, picked);
            }
            --window->idle_threads;
        }
        if (!job)
            return;
        job->evicted.reset();
        announce();
        window->finish(job->index, load(*job));
        window->changed.notify_all();
        window->work.notify_one();
        announce();
    }
}

std::size_t TimeStepCache::smallest_budget(const TimeStepSource& source) {
    return std::min(smallest_window, source.times().size()) *
           std::max<std::size_t>(1, source.bytes_per_step());
}

TimeStepCache::TimeStepCache(std::shared_ptr<const TimeStepSource> source, Options options)
    : state_(std::make_unique<State>()) {
    state_->source = std::move(source);
    state_->step_bytes = std::max<std::size_t>(1, state_->source->bytes_per_step());
    auto& window = *state_->window;
    state_->budget_bytes = options.account
                               ? smallest_budget(*state_->source)
                               : std::max(options.budget_bytes, smallest_budget(*state_->source));
    window.step_bytes = state_->step_bytes;
    window.smallest = smallest_budget(*state_->source) / state_->step_bytes;
    if (options.account) {
        state_->budget_bytes = std::max(options.account->budget(), state_->budget_bytes);
        window.account = options.account;
        window.share = options.account->open(MemoryUse::TimeSteps);
        window.share.set(window.smallest * window.step_bytes);
        state_->asked = options.account->on_need(
            GiveBack::TimeSteps, [window = state_->window, source = state_->source,
                                  state = state_.get()](std::size_t bytes) {
                std::vector<std::shared_ptr<const TimeStep>> freed;
                {
                    const std::scoped_lock lock(window->mutex);
                    freed = window->give_back_spare(bytes);
                }
                if (freed.empty())
                    return;
                freed.clear();
                source->let_go();
                state->announce();
            });
    }
    window.capacity = state_->budget_bytes / state_->step_bytes;
    window.entries.resize(state_->source->times().size());
    for (std::size_t i = 0; i < std::max<std::size_t>(1, options.load_threads); ++i)
        state_->threads.emplace_back(
            [state = state_.get()](const std::stop_token& stop) { state->load_until(stop); });
}

TimeStepCache::~TimeStepCache() {
    State::Window& window = *state_->window;
    state_->asked.reset();
    {
        const std::scoped_lock lock(window.mutex);
        window.closing = true;
        window.stop_loads([](const Entry&) { return true; });
    }
    state_->threads.clear();
    // A lease that outlives the cache keeps its own step, and none of the others.
    std::vector<std::shared_ptr<const TimeStep>> freed;
    const std::scoped_lock lock(window.mutex);
    for (Entry& entry : window.entries)
        freed.push_back(std::move(entry.step));
    window.share.shrink_to(window.lent * window.step_bytes);
}

const TimeStepSource& TimeStepCache::source() const {
    return *state_->source;
}

Result<std::shared_ptr<const TimeStep>>
TimeStepCache::acquire(std::size_t index, std::stop_token stop, std::size_t held) {
    State::Window& window = *state_->window;
    std::unique_lock lock(window.mutex);
    if (index >= window.entries.size())
        return fail(Error::Code::InvalidArgument, "there is no time-step " + std::to_string(index));
    Entry& entry = window.entries[index];
    if (entry.state == StepState::Resident) {
        ++window.hits;
        return window.lend(state_->window, index);
    }

    const auto failures = entry.failures;
    const auto done = [&] {
        return entry.state == StepState::Resident || entry.failures != failures;
    };
    window.demand(index);
    ++entry.waiters;
    window.held += held;
    window.work.notify_one();
    Patience patience;
    bool given_up = false;
    while (!window.changed.wait_for(lock, stop, look, done) && !stop.stop_requested() &&
           !given_up) {
        given_up = patience.ends(window.lent >= window.room(), window.may_be_deadlocked(),
                                 window.progress);
        window.work.notify_one(); // others may have given memory back
    }
    window.held -= held;
    window.withdraw(index);

    if (entry.state == StepState::Resident)
        return window.lend(state_->window, index);
    if (entry.failures != failures)
        return tl::unexpected(entry.error);
    if (given_up)
        return over_limit(window.room(),
                          "the time-step cache is full of time-steps in use (" +
                              std::to_string(window.room()) + ")",
                          "try again when other surfaces are done, or start with more --memory");
    return fail(Error::Code::Cancelled,
                "waiting for time-step " + std::to_string(index) + " was cancelled");
}

void TimeStepCache::prefetch(std::size_t index, int direction, std::size_t behind) {
    State::Window& window = *state_->window;
    const auto count = window.entries.size(); // fixed at construction, as the capacity
    // As far as the series goes; wraps below 0: no step.
    const auto row = [&](std::size_t length, bool upward) {
        std::vector<std::size_t> steps;
        for (std::size_t i = 1; i <= length && i <= count; ++i)
            if (const std::size_t next = upward ? index + i : index - i; next < count)
                steps.push_back(next);
            else
                break;
        return steps;
    };
    const auto kept = row(behind, direction < 0);
    const std::size_t room = window.capacity - std::min(window.capacity, kept.size() + 1);
    const auto ahead = row(room, direction > 0);
    std::vector<bool> cold(count);
    {
        const std::scoped_lock lock(window.mutex);
        for (const std::size_t i : ahead)
            cold[i] = window.entries[i].state == StepState::Cold;
    }
    std::deque<std::size_t> wanted; // ready() asks the disk: not under the lock
    std::copy_if(ahead.begin(), ahead.end(), std::back_inserter(wanted),
                 [&](std::size_t i) { return cold[i] && state_->source->ready(i); });

    const std::scoped_lock lock(window.mutex);
    for (Entry& entry : window.entries)
        entry.in_window = false;
    for (const auto& steps : {kept, ahead})
        for (const std::size_t i : steps)
            window.entries[i].in_window = true;
    if (index < count)
        window.entries[index].in_window = true;
    window.position = index;
    window.prefetched = std::move(wanted);
    window.stop_loads([](const Entry& e) { return e.waiters == 0 && !e.in_window; });
    window.work.notify_all();
}

TimeStepCache::Status TimeStepCache::status() const {
    const State::Window& window = *state_->window;
    Status status;
    const std::scoped_lock lock(state_->window->mutex);
    status.budget = state_->budget_bytes;
    if (window.account) {
        const std::size_t leave = window.account->budget() / left_free;
        const std::size_t free = window.account->free();
        status.budget = window.share.bytes() + (free - std::min(free, leave));
    }
    status.bytes = window.used * state_->step_bytes;
    status.hits = window.hits;
    status.loads = window.loads;
    status.steps.reserve(window.entries.size());
    for (const Entry& entry : window.entries)
        status.steps.push_back(entry.state);
    return status;
}

void TimeStepCache::on_change(std::function<void()> listener) {
    const std::scoped_lock lock(state_->listener_mutex);
    state_->listener = std::move(listener);
}

} // namespace wakesurf::core
