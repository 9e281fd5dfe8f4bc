// The MPI job that holds a store's bricks, as a child of the server: begun, listened to, ended. POSIX, no shell.
#pragma once

#include "core/base/result.hpp"
#include "server/service/base/private_file.hpp"

#include <sys/types.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// A program with its arguments, as a person writes it: words between blanks, quotes hold some together. No variables, no patterns.
/// Error: InvalidArgument where it has no word.
core::Result<std::vector<std::string>> program_words(std::string_view text);

/// A child and all that it starts on this machine. Ends with this: it is asked to, and killed where it does not within some seconds.
class BricksJob {
  public:
    /// The first word is looked up in PATH. Error: Io where it cannot be started.
    static core::Result<std::unique_ptr<BricksJob>> start(std::vector<std::string> words);
    ~BricksJob();
    BricksJob(const BricksJob&) = delete;
    BricksJob& operator=(const BricksJob&) = delete;

    /// Becomes readable when it says something, or has ended.
    int output() const { return output_.get(); }

    /// Whole lines of what it said since the last time.
    std::vector<std::string> lines();

    /// It says nothing any more.
    bool ended() const { return ended_; }

  private:
    BricksJob(pid_t process, OpenFile output) : process_(process), output_(std::move(output)) {}

    pid_t process_;
    OpenFile output_;
    std::string text_;
    bool ended_ = false;
};

} // namespace wakesurf::server
