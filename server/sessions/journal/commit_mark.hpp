// The number of changes that a server has acknowledged, in a file beside the database: SQLite takes a damaged
// or missing log for one of fewer changes, and so would we.
#pragma once

#include "server/base/private_file.hpp"
#include "server/sessions/journal/state_layout.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Keeps the mark. Writing does not wait for the disk: it survives the process, and after a power cut it is
/// at most too low. If it cannot be written, damage is not noticed, but nothing else is lost.
class CommitMark {
  public:
    struct Value {
        std::int64_t id = 0; ///< of the database
        std::int64_t commits = 0;
    };

    explicit CommitMark(std::string path) : path_(std::move(path)) {}

    /// Returns the mark; empty if there is none.
    std::optional<Value> read() const;

    void write(const Value& value);

    /// Opens the file again before the next write: it may have been removed.
    void close();

  private:
    std::string path_;
    OpenFile file_;
};

} // namespace wakesurf::server
