// How many changes a server has acknowledged, beside the file that holds them: a log that was damaged or
// taken away looks to SQLite like one of fewer changes, and would do so to us.
#pragma once

#include "server/service/base/private_file.hpp"
#include "server/service/journal/state_layout.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Written without waiting for the disk: it survives the process, and after a power cut it is at most
/// behind. Where it cannot be written nothing is noticed, and nothing else is lost.
class CommitMark {
  public:
    struct Value {
        std::int64_t id = 0; ///< of the file meant
        std::int64_t commits = 0;
    };

    explicit CommitMark(std::string path) : path_(std::move(path)) {}

    /// Returns nothing where there is none.
    std::optional<Value> read() const;

    void write(const Value& value);

    /// Opens the file again before the next write: it may have been taken away.
    void close();

  private:
    std::string path_;
    OpenFile file_;
};

} // namespace wakesurf::server
