// The journal on SQLite: a thread of its own writes what the loop's thread queues. All queued changes go into
// one transaction, so that a burst of edits costs one sync of the disk.
#pragma once

#include "server/base/journal.hpp"
#include "server/base/loop.hpp"
#include "server/sessions/journal/pending_writes.hpp"
#include "server/sessions/journal/state_store.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::server {

/// Writes changes. While the disk refuses (full, read-only, failing), changes stay in memory, callers are
/// told at once, and a try is made every `retry`; the one that succeeds writes all of them.
class SqliteJournal final : public Journal {
  public:
    /// Called on the loop when the disk starts to refuse (an error) and when it takes changes again.
    using OnDurability = std::function<void(core::Result<void>)>;

    /// REQUIRES: the loop outlives it.
    SqliteJournal(Loop& loop,
                  StateStore store,
                  OnDurability changed,
                  std::chrono::milliseconds retry = std::chrono::seconds(1));

    /// Does what finish() does.
    ~SqliteJournal() override;
    SqliteJournal(const SqliteJournal&) = delete;
    SqliteJournal& operator=(const SqliteJournal&) = delete;

    void write(const std::string& session, std::vector<JournalEntry> entries) override;
    void set_aside(const std::string& session, std::vector<KeptAside> records) override;
    void remove(const std::string& session) override;
    void settled(std::function<void(core::Result<void>)> done) override;
    std::optional<core::Error> refusal() const override;

    /// Keeps the file unchanged, with all written changes in it, while edits continue: until release(). For
    /// any thread but the loop's; waits for the disk. Error: Io while the disk refuses, and once the journal
    /// has finished.
    core::Result<void> hold();

    /// Returns whether the file was unchanged all the time.
    bool release();

    /// Writes the remaining changes, if the disk takes them, and posts the last callbacks. Waits for the
    /// disk. Later changes are not kept.
    void finish();

  private:
    using Errand = std::function<void(StateStore&)>;
    using Waiting = std::vector<std::function<void(core::Result<void>)>>;

    void work(const std::stop_token& stop);
    bool run(Errand errand);
    void wait_for_work(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);

    bool ending() const { return thread_.get_stop_token().stop_requested(); }

    void tell(PendingWrites tried, const core::Result<void>& outcome, Waiting waited);

    Loop& loop_;
    StateStore store_; ///< the thread's own
    OnDurability durability_changed_;
    std::chrono::milliseconds retry_;

    mutable std::mutex mutex_; ///< guards all below; never held while the disk is waited for
    std::condition_variable_any wake_;
    PendingWrites changes_;
    Waiting waiting_;
    std::vector<Errand> errands_;
    std::optional<core::Error> refusal_; ///< of the last try
    bool writing_ = false;

    std::jthread thread_; ///< destroyed first: it uses the others
};

} // namespace wakesurf::server
