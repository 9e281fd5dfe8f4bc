#include "server/data/bricks/rank_bricks.hpp"

#include "core/base/either_stop.hpp"
#include "server/base/log_text.hpp"
#include "server/data/bricks/brick_reads.hpp"
#include "server/data/bricks/bricks_job.hpp"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace wakesurf::server {

namespace {

WantedJob job_of(const store::StoreReader& reader) {
    const core::BrickLayout& layout = reader.bricks()->layout();
    WantedJob wanted;
    wanted.shape = {layout.dimensions(), layout.cells(), reader.times().size(),
                    3 * layout.nodes_per_brick()};
    wanted.contradicts = [&reader](std::string_view marks) {
        (void)reader.refresh(); // the job may know more time-steps
        return reader.contradicts(marks);
    };
    return wanted;
}

} // namespace

RankedStore::RankedStore(std::shared_ptr<const store::StoreReader> reader,
                         RankBricks::Options options)
    : reader_(std::move(reader)), ranks_(*reader_->bricks(), job_of(*reader_), std::move(options)) {
}

using core::BrickRead;
using core::Error;
using core::Result;

struct RankBricks::State {
    State(const core::BrickSource& from_files, WantedJob its_job, Options how)
        : wanted(std::move(its_job)), options(std::move(how)),
          bell(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), files(from_files) {
        wanted.patience = options.patience;
    }

    WantedJob wanted;
    Options options;
    OpenFile bell; ///< wakes the thread
    ReadsFromFiles files;
    std::mutex mutex;
    std::deque<WaitingRead> queue; ///< guarded by the mutex, as what follows
    Status status;
    std::condition_variable job_came;

    /// The members below are the thread's own.
    JobKeeper keeper{options, wanted};
    ReadsOnTheirWay on_their_way{options};
    bool damage_told = false;
    std::jthread thread; ///< destroyed first

    void ring() const {
        const std::uint64_t one = 1;
        (void)!::write(bell.get(), &one, sizeof(one));
    }

    void tend(const std::stop_token& unwanted);
    void wait();
    void poll();
    void welcome();
    void ask();
    Result<void> take_answers();
    Result<void> lose_patience();
    std::vector<WaitingRead> all_that_wait();
    void end_job(const Error& why);
};

/// Returns all reads of the job, which will not answer them.
std::vector<WaitingRead> RankBricks::State::all_that_wait() {
    std::vector<WaitingRead> all = on_their_way.end();
    const std::scoped_lock lock(mutex);
    status.there = false;
    status.ranks = status.held = 0;
    std::ranges::move(queue, std::back_inserter(all));
    queue.clear();
    return all;
}

void RankBricks::State::end_job(const Error& why) {
    spdlog::warn("event=bricks_job_ended message={} hint={}",
                 log_value(why.message + ": bricks come from files until there is another one"),
                 log_value(why.hint));
    files.begin(all_that_wait());
    keeper.end();
}

void RankBricks::State::welcome() {
    damage_told = false;
    const std::scoped_lock lock(mutex);
    status.there = true;
    status.ranks = keeper.talk()->ranks();
    status.held = keeper.talk()->held();
    ++status.jobs;
    job_came.notify_all();
}

void RankBricks::State::ask() {
    std::vector<WaitingRead> ended, now;
    {
        const std::scoped_lock lock(mutex);
        while (!queue.empty() && now.size() < keeper.talk()->free()) {
            WaitingRead next = std::move(queue.front());
            queue.pop_front();
            (next.asked->stop.stop_requested() ? ended : now).push_back(std::move(next));
        }
    }
    for (const WaitingRead& each : ended)
        each.cancel();
    if (now.empty())
        return;
    std::vector<BrickAsk> asks;
    for (const WaitingRead& each : now)
        asks.push_back({0, static_cast<std::uint32_t>(each.read().brick), each.read().step});
    const auto slots = keeper.talk()->ask(asks);
    if (!slots) {
        files.begin(std::move(now));
        return end_job(slots.error());
    }
    on_their_way.add(*slots, std::move(now));
}

Result<void> RankBricks::State::take_answers() {
    const auto filled = keeper.talk()->filled();
    if (!filled)
        return tl::unexpected(filled.error());
    std::vector<WaitingRead> not_held;
    for (const std::uint32_t slot : *filled) {
        const auto waiting = on_their_way.take(slot);
        if (!waiting) {
            keeper.talk()->drop(slot);
            continue;
        }
        const auto outcome = keeper.talk()->take(slot, waiting->read().to);
        if (outcome != JobTalk::Outcome::Taken)
            not_held.push_back(*waiting);
        {
            const std::scoped_lock lock(mutex);
            status.by_ranks += outcome == JobTalk::Outcome::Taken ? 1 : 0;
            status.damaged += outcome == JobTalk::Outcome::Damaged ? 1 : 0;
        }
        if (outcome == JobTalk::Outcome::Damaged && !std::exchange(damage_told, true))
            spdlog::warn("event=bricks_job message=\"brick {} of time-step {} came damaged from "
                         "the ranks, and is read from files\"",
                         waiting->read().brick, waiting->read().step);
        if (outcome == JobTalk::Outcome::Taken)
            waiting->tell({});
    }
    files.begin(std::move(not_held));
    return {};
}

Result<void> RankBricks::State::lose_patience() {
    std::vector<WaitingRead> late = on_their_way.late();
    if (keeper.talk()->free() == 0 && on_their_way.nobody_waits()) {
        const std::scoped_lock lock(mutex); // it will not answer any more
        std::ranges::move(queue, std::back_inserter(late));
        queue.clear();
    }
    files.begin(std::move(late));
    if (on_their_way.hung())
        return core::fail(Error::Code::Io, "the job does not answer");
    return {};
}

/// Waits until there is work.
void RankBricks::State::wait() {
    constexpr Duration longest{60'000};
    std::vector<pollfd> watched{{bell.get(), POLLIN, 0}};
    keeper.watch(watched);
    const auto due = std::min(keeper.due(), on_their_way.due());
    const auto now = options.wall().now();
    const auto wait =
        due > now + longest ? longest : std::max(std::chrono::ceil<Duration>(due - now), {});
    (void)::poll(watched.data(), watched.size(), static_cast<int>(wait.count()));
    std::uint64_t rings = 0;
    (void)!::read(bell.get(), &rings, sizeof(rings));
}

void RankBricks::State::poll() {
    const auto came = keeper.tend();
    if (!came)
        return end_job(came.error());
    if (*came)
        welcome();
    if (keeper.talk() == nullptr)
        return;
    if (auto well = take_answers().and_then([&] { return lose_patience(); }); !well)
        return end_job(well.error());
    ask();
}

void RankBricks::State::tend(const std::stop_token& unwanted) {
    const core::EitherStop stop(options.closing, unwanted);
    const std::stop_callback wake(stop.token(), [this] { ring(); });
    for (; !stop.token().stop_requested(); wait())
        poll();
    for (const WaitingRead& each : all_that_wait())
        each.cancel();
    keeper.end();
}

RankBricks::RankBricks(const core::BrickSource& files, WantedJob wanted, Options options)
    : files_(files), state_(std::make_unique<State>(files, std::move(wanted), std::move(options))) {
}

void RankBricks::begin() {
    if (!state_->thread.joinable())
        state_->thread = std::jthread(
            [state = state_.get()](const std::stop_token& stop) { state->tend(stop); });
}

RankBricks::~RankBricks() {
    state_->thread.request_stop();
}

void RankBricks::read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const {
    const auto asked = std::make_shared<AskedReads>(
        AskedReads{std::move(reads), std::move(stop), std::move(done)});
    std::vector<WaitingRead> by_files;
    bool any = false;
    {
        const BrickShape& shape = state_->wanted.shape;
        const std::scoped_lock lock(state_->mutex);
        for (std::size_t i = 0; i < asked->reads.size(); ++i) {
            const BrickRead& each = asked->reads[i];
            const bool ranks = state_->status.there && each.field == 0 && each.step < shape.steps &&
                               each.brick < files_.layout().count() &&
                               each.to.size() == shape.values;
            if (ranks)
                state_->queue.push_back({asked, i});
            else
                by_files.push_back({asked, i});
            any = any || ranks;
        }
    }
    if (any)
        state_->ring();
    state_->files.begin(std::move(by_files));
}

bool RankBricks::wait_for_job(std::uint64_t jobs, Duration most) const {
    std::unique_lock lock(state_->mutex);
    return state_->job_came.wait_for(lock, most, [&] { return state_->status.jobs >= jobs; });
}

std::size_t RankBricks::shared_bytes() const {
    return state_->wanted.slots * brick_record_bytes(state_->wanted.shape.values);
}

RankBricks::Status RankBricks::status() const {
    const std::uint64_t by_files = state_->files.count();
    const std::scoped_lock lock(state_->mutex);
    Status out = state_->status;
    out.by_files = by_files;
    return out;
}

} // namespace wakesurf::server
