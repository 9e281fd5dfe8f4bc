// A small private file that the loop's thread changes without waiting for its disk.
#pragma once

#include "core/base/result.hpp"
#include "server/base/loop.hpp"

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::server {

/// Writes the file on a thread of its own, from the first change on. Changes that wait for the disk are
/// written together.
class WriteBehindFile {
  public:
    using Done = std::function<void(core::Result<void>)>;

    /// REQUIRES: the loop outlives it.
    WriteBehindFile(Loop& loop, std::filesystem::path file) : loop_(loop), file_(std::move(file)) {}

    /// Writes the pending change. Waits for the disk.
    ~WriteBehindFile() = default;
    WriteBehindFile(const WriteBehindFile&) = delete;
    WriteBehindFile& operator=(const WriteBehindFile&) = delete;

    /// Replaces the whole text. `done` is posted to the loop once it, or a newer one, is on the disk. Error:
    /// as write_private_file.
    void put(std::string text, Done done);

    /// Adds to the end of the text. Error: as append_private_file; then none of it is there.
    void append(std::string text, Done done);

  private:
    void wake();
    void work(const std::stop_token& stop);

    Loop& loop_;
    std::filesystem::path file_;
    std::mutex mutex_; ///< guards what follows; never held while the disk is waited for
    std::condition_variable_any wake_;
    std::optional<std::string> text_; ///< to be written; empty: the file's own
    std::string more_;                ///< to follow it
    std::vector<Done> waiting_;
    std::jthread thread_; ///< destroyed first: it uses the others
};

} // namespace wakesurf::server
