#include "server/sessions/journal/sqlite_journal.hpp"

#include <future>
#include <memory>
#include <utility>

namespace wakesurf::server {

namespace {

/// The interval at which the file is checked while nothing is written.
constexpr std::chrono::seconds look{2};

} // namespace

SqliteJournal::SqliteJournal(Loop& loop,
                             StateStore store,
                             OnDurability changed,
                             std::chrono::milliseconds retry)
    : loop_(loop), store_(std::move(store)), durability_changed_(std::move(changed)), retry_(retry),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

SqliteJournal::~SqliteJournal() {
    finish();
}

void SqliteJournal::finish() {
    thread_.request_stop();
    if (thread_.joinable())
        thread_.join();
}

void SqliteJournal::write(const std::string& session, std::vector<JournalEntry> entries) {
    {
        const std::lock_guard lock(mutex_);
        changes_.write(session, std::move(entries));
    }
    wake_.notify_one();
}

void SqliteJournal::set_aside(const std::string& session, std::vector<KeptAside> records) {
    {
        const std::lock_guard lock(mutex_);
        changes_.set_aside(session, std::move(records));
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
    if (ending())
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

/// Returns false if the thread has ended.
bool SqliteJournal::run(Errand errand) {
    const auto done = std::make_shared<std::promise<void>>();
    std::future<void> ended = done->get_future();
    {
        const std::lock_guard lock(mutex_);
        if (ending())
            return false;
        errands_.push_back([errand = std::move(errand), done](StateStore& store) {
            errand(store);
            done->set_value();
        });
    }
    wake_.notify_one();
    ended.wait();
    return true;
}

core::Result<void> SqliteJournal::hold() {
    core::Result<void> held;
    if (!run([&](StateStore& store) { held = store.hold(); }))
        return core::fail(core::Error::Code::Io, "the server is ending", "try again");
    return held;
}

bool SqliteJournal::release() {
    bool whole = false;
    return run([&](StateStore& store) { whole = store.release(); }) && whole;
}

void SqliteJournal::wait_for_work(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    if (refusal_)
        wake_.wait_for(lock, stop, retry_, [] { return false; });
    else
        wake_.wait_for(lock, stop, look, [this] {
            return !changes_.empty() || !waiting_.empty() || !errands_.empty();
        });
}

void SqliteJournal::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    for (bool last = false; !last;) {
        wait_for_work(lock, stop);
        last = stop.stop_requested();
        PendingWrites changes = std::exchange(changes_, {});
        Waiting waiting = std::exchange(waiting_, {});
        const std::vector<Errand> errands = std::exchange(errands_, {});
        const bool refused = refusal_.has_value();
        writing_ = true;
        lock.unlock();
        core::Result<void> outcome;
        if (refused || !changes.empty() || !store_.in_place())
            outcome = store_.apply(changes);
        if (last && !outcome && !store_.in_place()) // no later try can restore it
            outcome = store_.apply(changes);
        for (const Errand& each : errands)
            each(store_);
        lock.lock();
        writing_ = false;
        tell(std::move(changes), outcome, std::move(waiting));
    }
}

// Holds the lock, so that clients never hear of a later state before an earlier one.
void SqliteJournal::tell(PendingWrites tried, const core::Result<void>& outcome, Waiting waited) {
    // The disk takes writes again, but edits in between were answered as not durable: they go first.
    const bool behind = outcome && refusal_ && !changes_.empty();
    const bool changed = !behind && refusal_.has_value() == outcome.has_value();
    if (outcome) {
        if (!behind)
            refusal_.reset();
    } else {
        refusal_ = outcome.error();
        changes_.follow(std::move(tried));
        // Their edits came during this try: the next one writes them.
        std::move(waiting_.begin(), waiting_.end(), std::back_inserter(waited));
        waiting_.clear();
    }
    if (changed || !waited.empty())
        loop_.post([told = durability_changed_, changed, outcome, waited = std::move(waited)] {
            if (changed && told)
                told(outcome);
            for (const auto& done : waited)
                done(outcome);
        });
}

} // namespace wakesurf::server
