#include "core/dataset/time_step_cache.hpp"

#include "core/base/blocking_wait.hpp"
#include "core/dataset/brick_cache.hpp"
#include "core/dataset/step_window.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace wakesurf::core {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// The poll interval of a caller that waits for room; after so many polls without a release it gives up. It is
// short when the callers that wait may between them hold everything (a deadlock).
constexpr auto poll_interval = 100ms;
constexpr int polls_when_deadlocked = 3;
constexpr int polls_when_merely_full = 300;

// After so many polls, reading is a matter of a slow server, and other jobs run meanwhile. Not at once, and
// not while waiting for room: they would hold time-steps too.
constexpr int polls_when_slow = 10;

constexpr std::size_t fewest_steps = 4;

// Limits how long an acquire() that waits for room may see nothing given back.
class Patience {
  public:
    bool ends(bool full, bool maybe_deadlocked, std::uint64_t progress) {
        if (!full || progress != progress_)
            full_polls_ = deadlocked_polls_ = 0;
        progress_ = progress;
        full_polls_ += full ? 1 : 0;
        deadlocked_polls_ = maybe_deadlocked ? deadlocked_polls_ + 1 : 0;
        return full_polls_ >= polls_when_merely_full || deadlocked_polls_ >= polls_when_deadlocked;
    }

  private:
    std::uint64_t progress_ = 0;
    int full_polls_ = 0;
    int deadlocked_polls_ = 0;
};

} // namespace

struct TimeStepCache::State {
    using Window = StepWindow;

    std::shared_ptr<const TimeStepSource> source;
    std::size_t step_bytes = 0;
    std::size_t budget_bytes = 0;
    std::shared_ptr<Window> window = std::make_shared<Window>();
    std::mutex listener_mutex;
    std::function<void()> listener;
    std::vector<std::jthread> threads;
    std::shared_ptr<void> asked; ///< by others, for memory
    std::shared_ptr<BrickCache> bricks;
    std::atomic<BrickTable::Age> prefetched_at{0}; ///< of the bricks

    Result<std::shared_ptr<const TimeStep>> load(const StepJob& job) const;
    void load_until(const std::stop_token& stop);
    void announce();
    Result<std::shared_ptr<const TimeStep>> in_bricks(std::size_t index) const;
    void prefetch_bricks(std::size_t index, int direction);
};

Result<std::shared_ptr<const TimeStep>> TimeStepCache::State::load(const StepJob& job) const {
    try {
        return source->load(job.index, job.stop);
    } catch (const std::bad_alloc&) {
        return fail(Error::Code::OverLimit,
                    "there is not enough memory for time-step " + std::to_string(job.index) + " (" +
                        std::to_string(step_bytes) + " bytes)",
                    "start with a smaller --memory");
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
    const std::stop_callback wake(stop, [this] { window->work.notify_all(); });
    while (true) {
        std::optional<StepJob> job;
        {
            std::unique_lock lock(window->mutex);
            ++window->idle_threads;
            const auto picked = [&] { return (job = window->pick()).has_value(); };
            for (auto seen = window->work.notifications(); !stop.stop_requested() && !picked();
                 seen = window->work.notifications()) {
                if (!window->hungry()) {
                    window->work.wait(lock, seen);
                    continue;
                }
                lock.unlock();
                window->account->make_room(step_bytes); // of others: a caller waits for it
                lock.lock();
                // The loop ends by time however often others notify, because asking them costs them
                // something.
                const auto end = Clock::now() + poll_interval;
                for (seen = window->work.notifications();
                     !stop.stop_requested() && !picked() && Clock::now() < end;
                     seen = window->work.notifications())
                    window->work.wait(lock, seen, end - Clock::now());
                if (job)
                    break;
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

std::size_t TimeStepCache::smallest_window(const TimeStepSource& source) {
    return std::min(fewest_steps, source.times().size()) *
           std::max<std::size_t>(1, source.bytes_per_step());
}

std::size_t TimeStepCache::smallest_budget(const TimeStepSource& source) {
    const std::size_t window = smallest_window(source);
    return source.bricks() == nullptr
               ? window
               : std::min(window, BrickCache::smallest_budget(source.bricks()->layout()));
}

bool TimeStepCache::pages(const TimeStepSource& source, std::size_t budget_bytes) {
    return source.bricks() != nullptr && smallest_window(source) > budget_bytes;
}

TimeStepCache::TimeStepCache(std::shared_ptr<const TimeStepSource> source, Options options)
    : state_(std::make_unique<State>()) {
    state_->source = std::move(source);
    state_->step_bytes = std::max<std::size_t>(1, state_->source->bytes_per_step());
    auto& window = *state_->window;
    const std::size_t whole = smallest_window(*state_->source);
    const std::size_t room =
        options.account ? std::min(room_in(options.account->budget()), options.account->free())
                        : options.budget_bytes;
    const BrickSource* bricks = state_->source->bricks();
    if (pages(*state_->source, room) || (bricks != nullptr && options.by_brick)) {
        state_->bricks = std::make_shared<BrickCache>(
            *bricks, BrickCache::Options{options.budget_bytes, options.account,
                                         [state = state_.get()] { state->announce(); }});
        state_->budget_bytes = state_->bricks->status().budget;
        window.entries = std::vector<StepEntry>(state_->source->times().size());
        return;
    }
    state_->budget_bytes = options.account ? whole : std::max(options.budget_bytes, whole);
    window.step_bytes = state_->step_bytes;
    window.smallest = whole / state_->step_bytes;
    if (options.account) {
        state_->budget_bytes = std::max(options.account->budget(), state_->budget_bytes);
        window.account = options.account;
        window.share = options.account->open(MemoryUse::TimeSteps);
        window.share.set(window.smallest * window.step_bytes);
        state_->asked = options.account->on_need(
            ReclaimOrder::TimeSteps, [window = state_->window, source = state_->source,
                                      state = state_.get()](std::size_t bytes) {
                std::vector<std::shared_ptr<const TimeStep>> freed;
                {
                    const std::scoped_lock lock(window->mutex);
                    freed = window->reclaim_spare(bytes);
                }
                if (freed.empty())
                    return;
                freed.clear();
                source->release_memory();
                state->announce();
            });
    }
    window.capacity = state_->budget_bytes / state_->step_bytes;
    window.entries = std::vector<StepEntry>(state_->source->times().size());
    for (std::size_t i = 0; i < std::max<std::size_t>(1, options.load_threads); ++i)
        state_->threads.emplace_back(
            [state = state_.get()](const std::stop_token& stop) { state->load_until(stop); });
}

TimeStepCache::~TimeStepCache() {
    State::Window& window = *state_->window;
    state_->asked.reset();
    state_->bricks.reset();
    {
        const std::scoped_lock lock(window.mutex);
        window.closing = true;
        window.stop_loads([](const StepEntry&) { return true; });
    }
    state_->threads.clear();
    // A lease that outlives the cache keeps its own step, and none of the others.
    std::vector<std::shared_ptr<const TimeStep>> freed;
    const std::scoped_lock lock(window.mutex);
    for (StepEntry& entry : window.entries)
        freed.push_back(std::move(entry.step));
    window.share.shrink_to(window.lent * window.step_bytes);
}

const TimeStepSource& TimeStepCache::source() const {
    return *state_->source;
}

const std::shared_ptr<BrickCache>& TimeStepCache::bricks() const {
    return state_->bricks;
}

Result<std::shared_ptr<const TimeStep>> TimeStepCache::State::in_bricks(std::size_t index) const {
    if (!source->ready(index))
        return fail(Error::Code::NotFound,
                    "time-step " + std::to_string(index) + " is not there yet");
    auto step = std::make_shared<TimeStep>();
    step->index = index;
    step->time = source->times()[index];
    step->bricks = bricks->table(index);
    step->gaps = source->bricks()->gaps(index);
    return step;
}

void TimeStepCache::State::prefetch_bricks(std::size_t index, int direction) {
    const std::size_t count = source->times().size();
    const std::size_t next = direction > 0 ? index + 1 : index - 1; // wraps below 0: none
    const std::size_t begun = direction > 0 ? index - 1 : index + 1;
    if (begun >= count)
        return;
    const auto used = bricks->used(begun, prefetched_at.exchange(bricks->age()));
    // Reading ahead must leave room for the interval itself: without this a surface read 44 % more bytes of
    // time-steps that were four times the budget.
    if (3 * used.size() > bricks->capacity())
        return;
    std::vector<BrickName> wanted;
    for (const std::size_t step : {index, next})
        if (step < count && source->ready(step))
            for (const std::uint32_t brick : used)
                wanted.push_back({step, brick});
    bricks->prefetch(wanted);
}

Result<std::shared_ptr<const TimeStep>>
TimeStepCache::acquire(std::size_t index, std::stop_token stop, std::size_t held) {
    State::Window& window = *state_->window;
    if (state_->bricks && index < window.entries.size())
        return state_->in_bricks(index);
    // This stands before the lock, because its end waits for a call under way.
    const std::stop_callback wake(stop, [&] { window.changed.notify_all(); });
    std::unique_lock lock(window.mutex);
    if (index >= window.entries.size())
        return fail(Error::Code::InvalidArgument, "there is no time-step " + std::to_string(index));
    StepEntry& entry = window.entries[index];
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
    const auto waited = [&] {
        const auto end = Clock::now() + poll_interval;
        for (auto seen = window.changed.notifications();
             !done() && !stop.stop_requested() && Clock::now() < end;
             seen = window.changed.notifications())
            window.changed.wait(lock, seen, end - Clock::now());
        return done();
    };
    std::optional<BlockingWait> slow;
    for (int polls = 1; !waited() && !stop.stop_requested() && !given_up; ++polls) {
        if (polls >= polls_when_slow && !slow && window.lent < window.room())
            slow.emplace();
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
    if (state_->bricks) {
        state_->prefetch_bricks(index, direction);
        return;
    }
    State::Window& window = *state_->window;
    const auto count = window.entries.size(); // fixed at construction, as the capacity
    // The row ends where the series does; an index that wraps below 0 is no step.
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
    for (StepEntry& entry : window.entries)
        entry.in_window = false;
    for (const auto& steps : {kept, ahead})
        for (const std::size_t i : steps)
            window.entries[i].in_window = true;
    if (index < count)
        window.entries[index].in_window = true;
    window.position = index;
    window.prefetched = std::move(wanted);
    window.stop_loads([](const StepEntry& e) { return e.waiters == 0 && !e.in_window; });
    window.work.notify_all();
}

TimeStepCache::Status TimeStepCache::status() const {
    const State::Window& window = *state_->window;
    Status status;
    status.budget = state_->budget_bytes;
    if (window.account) {
        const std::size_t leave = window.account->budget() / StepWindow::left_free;
        const std::size_t free = window.account->free();
        status.budget = std::max(window.used.load(), window.smallest) * window.step_bytes +
                        (free - std::min(free, leave));
    }
    if (state_->bricks) {
        const BrickCache::Status bricks = state_->bricks->status();
        status.bytes = bricks.bytes;
        status.loads = bricks.reads;
        const BrickLayout& layout = state_->bricks->layout();
        const std::size_t brick = layout.nodes_per_brick() * 3 * sizeof(float);
        status.step_bytes = layout.count() * brick;
        status.steps.resize(window.entries.size());
        for (const auto& [step, held] : state_->bricks->held())
            status.steps[step] = {held.resident * brick, held.loading * brick};
        return status;
    }
    status.bytes = window.used * state_->step_bytes;
    status.hits = window.hits;
    status.loads = window.loads;
    status.step_bytes = state_->step_bytes;
    status.steps.reserve(window.entries.size());
    for (const StepEntry& entry : window.entries) {
        const StepState state = entry.state;
        status.steps.push_back({state == StepState::Resident ? status.step_bytes : 0,
                                state == StepState::Loading ? status.step_bytes : 0});
    }
    return status;
}

void TimeStepCache::on_change(std::function<void()> listener) {
    const std::scoped_lock lock(state_->listener_mutex);
    state_->listener = std::move(listener);
}

} // namespace wakesurf::core
