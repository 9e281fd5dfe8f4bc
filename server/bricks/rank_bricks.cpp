#include "server/bricks/rank_bricks.hpp"

#include "server/base/log_text.hpp"
#include "server/bricks/bricks_job.hpp"
#include "server/bricks/local_socket.hpp"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace wakesurf::server {

using core::BrickRead;
using core::Error;
using core::Result;
using Clock = std::chrono::steady_clock;

namespace {

/// What was asked for in one call.
struct AskedReads {
    std::vector<BrickRead> reads;
    std::stop_token stop;
    core::BrickSource::Done done;
};

/// One of them.
struct WaitingRead {
    std::shared_ptr<AskedReads> asked;
    std::size_t index = 0;

    const BrickRead& read() const { return asked->reads[index]; }

    void tell(Result<void> outcome) const { asked->done(index, std::move(outcome)); }
};

tl::unexpected<Error> reading_ended() {
    return core::fail(Error::Code::Cancelled, "reading the brick was cancelled");
}

} // namespace

struct RankBricks::State {
    State(const core::BrickSource& from_files, WantedJob its_job, Options how)
        : files(from_files), wanted(std::move(its_job)), options(std::move(how)),
          bell(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), rest(options.first_rest) {}

    const core::BrickSource& files;
    WantedJob wanted;
    Options options;
    OpenFile bell; ///< rung for the thread
    std::mutex mutex;
    std::deque<WaitingRead> queue; ///< guarded by the mutex, as what follows
    bool there = false;
    std::size_t in_files = 0; ///< reads that files have not answered yet
    Status status;
    std::condition_variable changed; ///< in_files or status

    /// The thread's own.
    struct OnItsWay {
        std::optional<WaitingRead> read; ///< none: files have it by now
        Clock::time_point since;
    };

    std::optional<LocalDoor> door;
    std::unique_ptr<BricksJob> job;
    std::optional<OpenFile> guest; ///< knocked, and has not said who it is
    std::optional<JobTalk> talk;
    std::vector<std::optional<OnItsWay>> on_their_way; ///< by slot
    Clock::time_point started{}, heard{}, next_start{};
    Duration rest;
    bool damage_told = false;
    std::jthread thread; ///< last

    void ring() const {
        const std::uint64_t one = 1;
        (void)!::write(bell.get(), &one, sizeof(one));
    }

    void from_files(std::vector<WaitingRead> which);
    void to_files_those_of_job();
    void tend(const std::stop_token& stop);
    void start();
    void end_job(const Error& why);
    void look(const std::stop_token& stop);
    void listen_to_job();
    void let_in();
    void ask();
    Result<void> take_answers();
    void lose_patience();
    void end_all();
};

/// By call, so that files read neighbours in one go.
void RankBricks::State::from_files(std::vector<WaitingRead> which) {
    {
        const std::scoped_lock lock(mutex);
        in_files += which.size();
        status.by_files += which.size();
    }
    while (!which.empty()) {
        const auto asked = which.front().asked;
        const auto rest_of = std::stable_partition(
            which.begin(), which.end(), [&](const auto& each) { return each.asked == asked; });
        std::vector<BrickRead> reads;
        std::vector<std::size_t> indices;
        for (auto each = which.begin(); each != rest_of; ++each) {
            reads.push_back(each->read());
            indices.push_back(each->index);
        }
        which.erase(which.begin(), rest_of);
        files.read(
            std::move(reads), asked->stop,
            [this, asked, indices = std::move(indices)](std::size_t i, Result<void> outcome) {
                asked->done(indices[i], std::move(outcome));
                const std::scoped_lock lock(mutex);
                if (--in_files == 0)
                    changed.notify_all();
            });
    }
}

void RankBricks::State::to_files_those_of_job() {
    std::vector<WaitingRead> all;
    {
        const std::scoped_lock lock(mutex);
        there = false;
        status.there = false;
        status.ranks = status.held = 0;
        for (auto& each : on_their_way)
            if (each && each->read)
                all.push_back(std::move(*each->read));
        all.insert(all.end(), queue.begin(), queue.end());
        queue.clear();
    }
    on_their_way.clear();
    from_files(std::move(all));
}

void RankBricks::State::end_job(const Error& why) {
    spdlog::warn("event=bricks_job_ended message={} hint={}",
                 log_value(why.message + ": bricks come from files until there is another one"),
                 log_value(why.hint));
    to_files_those_of_job();
    guest.reset();
    talk.reset(); // the job hears of it, and ends
    listen_to_job();
    job.reset();
    listen_to_job();
    door.reset();
    next_start = Clock::now() + rest;
    rest = std::min(2 * rest, options.longest_rest);
}

void RankBricks::State::start() {
    auto opened = LocalDoor::open();
    if (opened) {
        door.emplace(std::move(*opened));
        std::vector<std::string> words = options.words;
        words.insert(words.end(), {options.program.string(), options.store.string(), "--socket",
                                   door->path().string()});
        if (options.memory > 0)
            words.insert(words.end(), {"--memory", std::to_string(options.memory)});
        auto begun = BricksJob::start(std::move(words));
        started = Clock::now();
        if (begun) {
            job = std::move(*begun);
            return;
        }
        return end_job(begun.error());
    }
    end_job(opened.error());
}

void RankBricks::State::listen_to_job() {
    if (job)
        for (const std::string& line : job->lines())
            if (!line.empty())
                spdlog::info("event=bricks_job message={}", log_value(line));
}

void RankBricks::State::let_in() {
    if (!guest)
        if (auto came = door->let_in())
            guest = std::move(*came);
    if (!guest)
        return;
    auto met = JobTalk::meet(*guest, wanted);
    if (!met)
        return end_job(met.error());
    if (!*met)
        return;
    guest.reset();
    talk = std::move(**met);
    on_their_way.resize(wanted.slots);
    rest = options.first_rest;
    damage_told = false;
    spdlog::info("event=bricks_job_there ranks={} bricks={}", talk->ranks(), talk->held());
    const std::scoped_lock lock(mutex);
    there = status.there = true;
    status.ranks = talk->ranks();
    status.held = talk->held();
    ++status.jobs;
    changed.notify_all();
}

void RankBricks::State::ask() {
    std::vector<WaitingRead> ended, now;
    {
        const std::scoped_lock lock(mutex);
        while (!queue.empty() && now.size() < talk->free()) {
            WaitingRead next = std::move(queue.front());
            queue.pop_front();
            (next.asked->stop.stop_requested() ? ended : now).push_back(std::move(next));
        }
    }
    for (const WaitingRead& each : ended)
        each.tell(reading_ended());
    if (now.empty())
        return;
    if (std::ranges::none_of(on_their_way, [](const auto& each) { return each.has_value(); }))
        heard = Clock::now(); // it owed nothing until now
    std::vector<BrickAsk> asks;
    for (const WaitingRead& each : now)
        asks.push_back({0, static_cast<std::uint32_t>(each.read().brick), each.read().step});
    const auto slots = talk->ask(asks);
    if (!slots) {
        from_files(std::move(now));
        return end_job(slots.error());
    }
    for (std::size_t i = 0; i < now.size(); ++i)
        on_their_way[(*slots)[i]] = OnItsWay{std::move(now[i]), Clock::now()};
}

Result<void> RankBricks::State::take_answers() {
    const auto filled = talk->filled();
    if (!filled)
        return tl::unexpected(filled.error());
    if (!filled->empty())
        heard = Clock::now();
    std::vector<WaitingRead> not_held;
    for (const std::uint32_t slot : *filled) {
        const auto on_its_way = std::exchange(on_their_way[slot], std::nullopt);
        if (!on_its_way->read) {
            talk->drop(slot);
            continue;
        }
        const WaitingRead& waiting = *on_its_way->read;
        const auto outcome = talk->take(slot, waiting.read().to);
        if (outcome != JobTalk::Outcome::Taken)
            not_held.push_back(waiting);
        {
            const std::scoped_lock lock(mutex);
            status.by_ranks += outcome == JobTalk::Outcome::Taken ? 1 : 0;
            status.damaged += outcome == JobTalk::Outcome::Damaged ? 1 : 0;
        }
        if (outcome == JobTalk::Outcome::Damaged && !std::exchange(damage_told, true))
            spdlog::warn("event=bricks_job message=\"brick {} of time-step {} came damaged from "
                         "the ranks, and is read from files\"",
                         waiting.read().brick, waiting.read().step);
        if (outcome == JobTalk::Outcome::Taken)
            waiting.tell({});
    }
    if (!not_held.empty())
        from_files(std::move(not_held));
    return {};
}

/// Their slots are taken until the job answers.
void RankBricks::State::lose_patience() {
    const auto now = Clock::now();
    std::vector<WaitingRead> late;
    bool any = false;
    for (auto& each : on_their_way) {
        any = any || each;
        if (each && each->read && now - each->since >= options.patience) {
            late.push_back(std::move(*each->read));
            each->read.reset();
        }
    }
    if (talk->free() == 0 &&
        std::ranges::none_of(on_their_way, [](const auto& each) { return each && each->read; })) {
        const std::scoped_lock lock(mutex); // it brings nothing more, as it seems
        late.insert(late.end(), queue.begin(), queue.end());
        queue.clear();
    }
    if (!late.empty())
        from_files(std::move(late));
    if (any && now - heard >= options.hung)
        end_job({Error::Code::Io, "the job does not answer", ""});
}

void RankBricks::State::look(const std::stop_token& stop) {
    std::vector<pollfd> files_open{{bell.get(), POLLIN, 0}};
    if (job && !job->ended() && job->output() >= 0)
        files_open.push_back({job->output(), POLLIN, 0});
    if (talk)
        files_open.push_back({talk->socket(), POLLIN, 0});
    else if (guest)
        files_open.push_back({guest->get(), POLLIN, 0});
    else if (door)
        files_open.push_back({door->file(), POLLIN, 0});
    const auto now = Clock::now();
    auto wait = Duration(60'000);
    const auto until = [&](Clock::time_point then) {
        wait = std::clamp(std::chrono::ceil<Duration>(then - now), Duration(0), wait);
    };
    if (!job)
        until(next_start);
    else if (!talk)
        until(started + options.coming);
    for (const auto& each : on_their_way)
        if (each)
            until(each->read ? each->since + options.patience : heard + options.hung);
    (void)::poll(files_open.data(), files_open.size(), static_cast<int>(wait.count()));
    std::uint64_t rings = 0;
    (void)!::read(bell.get(), &rings, sizeof(rings));
    if (stop.stop_requested())
        return;
    listen_to_job();
    if (!job) {
        if (Clock::now() >= next_start)
            start();
        return;
    }
    if (!talk)
        let_in();
    if (talk) {
        if (auto taken = take_answers(); !taken)
            return end_job(taken.error());
        lose_patience();
        if (talk)
            ask();
    } else if (job && job->ended()) {
        end_job({Error::Code::Io, "the job ended before it was there", "its own words are above"});
    } else if (job && Clock::now() - started >= options.coming) {
        end_job({Error::Code::Io, "the job does not come", ""});
    }
}

void RankBricks::State::tend(const std::stop_token& stop) {
    while (!stop.stop_requested())
        look(stop);
    end_all();
}

void RankBricks::State::end_all() {
    std::vector<WaitingRead> all;
    {
        const std::scoped_lock lock(mutex);
        there = false;
        for (auto& each : on_their_way)
            if (each && each->read)
                all.push_back(std::move(*each->read));
        all.insert(all.end(), queue.begin(), queue.end());
        queue.clear();
    }
    for (const WaitingRead& each : all)
        each.tell(reading_ended());
    talk.reset();
    guest.reset();
    job.reset();
    door.reset();
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
    state_->ring();
    if (state_->thread.joinable())
        state_->thread.join();
    std::unique_lock lock(state_->mutex);
    state_->changed.wait(lock, [&] { return state_->in_files == 0; });
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
            const bool ranks = state_->there && each.field == 0 && each.step < shape.steps &&
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
    if (!by_files.empty())
        state_->from_files(std::move(by_files));
}

bool RankBricks::wait_for_job(std::uint64_t jobs, Duration most) const {
    std::unique_lock lock(state_->mutex);
    return state_->changed.wait_for(lock, most, [&] { return state_->status.jobs >= jobs; });
}

std::size_t RankBricks::shared_bytes() const {
    return state_->wanted.slots * brick_record_bytes(state_->wanted.shape.values);
}

RankBricks::Status RankBricks::status() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->status;
}

} // namespace wakesurf::server
