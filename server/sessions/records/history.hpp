// Keeps what each author of a session can undo and redo: their own edits as records before and after. An
// edit may only be taken back, or done again, while its records are as it left them, so every step knows the
// revision it left; doing so to an edit sets a new revision of a record, which the author's neighbouring
// edits are told. The edits of one gesture (a slider that moves, a rake that is dragged, a button that makes
// two records) are one edit here.
#pragma once

#include "server/sessions/records/session_records.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::server {

enum class HistoryMove : std::uint8_t { Undo, Redo };

/// Holds one record of an edit, both ways.
struct EditStep {
    RecordKey key;
    std::shared_ptr<const Record> before; ///< null: it was not there
    std::shared_ptr<const Record> after;
    std::uint64_t before_rev = 0; ///< its revision while it is as before; 0: not there
    std::uint64_t after_rev = 0;
    std::uint64_t latest = 0; ///< the highest it had between, where a gesture left it gone

    /// Returns what the record becomes.
    const std::shared_ptr<const Record>& to(HistoryMove move) const {
        return move == HistoryMove::Undo ? before : after;
    }

    /// Returns the revision it must be at for that.
    std::uint64_t from_rev(HistoryMove move) const {
        return move == HistoryMove::Undo ? after_rev : before_rev;
    }
};

struct Edit {
    std::vector<EditStep> steps;
    /// Edits that follow each other with the same gesture become one; empty: never.
    std::string gesture;
};

/// Bounded in edits an author, authors, and bytes; the oldest go first.
class History {
  public:
    struct Depth {
        std::size_t undo = 0;
        std::size_t redo = 0;
    };

    /// Adds a new edit, or more of the newest one's gesture. Nothing can be done again after it.
    void add(const std::string& author, Edit edit);

    /// Takes the newest edit off, to take it back or to do it again. Gestures end here: what comes next is
    /// another edit.
    std::optional<Edit> take(const std::string& author, HistoryMove move);

    /// Notes that the edit that take() returned was taken back or done again; `revs` are its records'
    /// revisions now, step by step, 0 for those that are gone.
    void moved(const std::string& author,
               HistoryMove move,
               Edit edit,
               std::span<const std::uint64_t> revs);

    Depth depth(const std::string& author) const;

    /// Returns about how many bytes all that is kept takes.
    std::size_t bytes() const { return bytes_; }

  private:
    struct Kept {
        Edit edit;
        std::uint64_t age = 0;
        std::size_t bytes = 0;
    };

    using Stack = std::deque<Kept>;

    struct Stacks {
        Stack undo;
        Stack redo;
        std::uint64_t used = 0;
    };

    void push(Stack& stack, Edit edit);
    void drop(Stack& stack, bool newest);
    void clear(Stack& stack);
    void make_room();

    std::map<std::string, Stacks> authors_;
    std::uint64_t next_age_ = 1;
    std::size_t bytes_ = 0;
};

} // namespace wakesurf::server
