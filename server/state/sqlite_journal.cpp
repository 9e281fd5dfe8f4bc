#include "server/state/sqlite_journal.hpp"

#include <utility>

namespace wakesurf::server {

SqliteJournal::SqliteJournal(Loop& loop,
                             StateStore store,
                             Turn turned,
                             std::chrono::milliseconds retry)
    : loop_(loop), store_(std::move(store)), turned_(std::move(turned)), retry_(retry),
      thread_([this] { work(); }) {}

SqliteJournal::~SqliteJournal() {
    finish();
}

void SqliteJournal::finish() {
    if (!thread_.joinable())
        return;
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void SqliteJournal::write(const std::string& session, std::vector<JournalEntry> entries) {
    {
        const std::lock_guard lock(mutex_);
        changes_.write(session, std::move(entries));
    }
    wake_.notify_one();
}

void SqliteJournal::remove(const std::string& session) {
    {
        const std::lock_guard lock(mutex_);
        changes_.remove(session);
    }
    wake_.notify_one();
}

void SqliteJournal::settled(std::function<void(core::Result<void>)> done) {
    const std::lock_guard lock(mutex_);
    if (stopping_)
        loop_.post([done = std::move(done)] {
            done(core::fail(core::Error::Code::Io, "the server is ending", "try again"));
        });
    else if (refusal_)
        loop_.post([done = std::move(done), error = *refusal_] { done(tl::unexpected(error)); });
    else if (writing_ || !changes_.empty())
        waiting_.push_back(std::move(done));
    else
        loop_.post([done = std::move(done)] { done({}); });
}

std::optional<core::Error> SqliteJournal::refusal() const {
    const std::lock_guard lock(mutex_);
    return refusal_;
}

void SqliteJournal::wait_for_work(std::unique_lock<std::mutex>& lock) {
    if (refusal_)
        wake_.wait_for(lock, retry_, [this] { return stopping_; });
    else
        wake_.wait(lock, [this] { return stopping_ || !changes_.empty() || !waiting_.empty(); });
}

void SqliteJournal::work() {
    std::unique_lock lock(mutex_);
    for (bool last = false; !last;) {
        wait_for_work(lock);
        last = stopping_;
        PendingWrites changes = std::exchange(changes_, {});
        Waiting waiting = std::exchange(waiting_, {});
        const bool try_disk = refusal_ || !changes.empty();
        writing_ = true;
        lock.unlock();
        const core::Result<void> outcome = try_disk ? store_.apply(changes) : core::Result<void>{};
        lock.lock();
        writing_ = false;
        tell(std::move(changes), outcome, std::move(waiting));
    }
}

// With the lock held, so that nobody is told of a later state before an earlier one.
void SqliteJournal::tell(PendingWrites tried, const core::Result<void>& outcome, Waiting waited) {
    // The disk takes writes again, but edits came meanwhile that were answered as not durable: they go first.
    const bool behind = outcome && refusal_ && !changes_.empty();
    const bool turn = !behind && refusal_.has_value() == outcome.has_value();
    if (outcome) {
        if (!behind)
            refusal_.reset();
    } else {
        refusal_ = outcome.error();
        changes_.follow(std::move(tried));
        // Their edits came while this try was on its way: none is made for them before the next.
        std::move(waiting_.begin(), waiting_.end(), std::back_inserter(waited));
        waiting_.clear();
    }
    if (turn || !waited.empty())
        loop_.post([turned = turned_, turn, outcome, waited = std::move(waited)] {
            if (turn && turned)
                turned(outcome);
            for (const auto& done : waited)
                done(outcome);
        });
}

} // namespace wakesurf::server
