// All sessions of the server. One, `main`, is there from the start, so that a page and a script meet without
// arranging anything.
#pragma once

#include "server/session/build_turns.hpp"
#include "server/session/history_budget.hpp"
#include "server/session/session.hpp"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Loop thread only.
class SessionDirectory {
  public:
    explicit SessionDirectory(SessionServices services);

    /// Where there are too many, the oldest that nobody is in makes room, one without records first. Error: OverLimit when all are in use.
    core::Result<std::shared_ptr<Session>> create(std::string name);

    /// A new session with the records of another. Error: NotFound, OverLimit.
    core::Result<std::shared_ptr<Session>> fork(const std::string& id, std::string name);

    /// Brings a session back from what the journal kept of it. Before anybody is served.
    RestoreReport
    restore(const std::string& id, std::string name, std::span<const JournalEntry> entries);

    /// Error: NotFound.
    core::Result<std::shared_ptr<Session>> find(const std::string& id) const;

    /// Tells every session that more time-steps of a dataset can be read, or that it was opened again.
    void dataset_changed(const std::string& dataset);

    /// Writes the times of clocks that run into the journal: the server is ending.
    void keep_times() const;

    /// Called with the id of a session that had to make room.
    void on_removed(std::function<void(const std::string&)> tell) { removed_ = std::move(tell); }

    const std::map<std::string, std::shared_ptr<Session>>& all() const { return sessions_; }

  private:
    std::shared_ptr<Session> add(std::string id, std::string name);
    core::Result<std::shared_ptr<Session>> add_new(std::string name);
    bool make_room();

    BuildTurns turns_;
    HistoryBudget histories_;
    SessionServices services_;
    std::uint32_t next_surface_number_ = 1;
    std::size_t next_session_ = 1;
    std::map<std::string, std::shared_ptr<Session>> sessions_;
    std::deque<std::string> created_; ///< ids, oldest first; without `main`
    std::function<void(const std::string&)> removed_;
};

} // namespace wakesurf::server
