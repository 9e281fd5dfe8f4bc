// The MPI job that holds a store's bricks, as a child of the server: started, read, ended. POSIX, no shell.
#pragma once

#include "core/base/result.hpp"
#include "server/base/private_file.hpp"

#include <sys/types.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Splits a command line into words at blanks; quotes keep words together. No variables, no patterns. Error:
/// InvalidArgument without a word.
core::Result<std::vector<std::string>> program_words(std::string_view text);

/// A child and all processes that it starts on this machine. The destructor asks it to end, and kills it
/// after some seconds.
class BricksJob {
  public:
    /// Starts a job; its first word is looked up in PATH. Error: Io if it cannot be started.
    static core::Result<std::unique_ptr<BricksJob>> start(std::vector<std::string> words);
    ~BricksJob();
    BricksJob(const BricksJob&) = delete;
    BricksJob& operator=(const BricksJob&) = delete;

    /// Returns a descriptor that becomes readable with output or at the end.
    int output() const { return output_.get(); }

    /// Returns the whole lines of output since the last call.
    std::vector<std::string> lines();

    /// Says whether its output has ended.
    bool ended() const { return ended_; }

  private:
    BricksJob(pid_t process, OpenFile output) : process_(process), output_(std::move(output)) {}

    pid_t process_;
    OpenFile output_;
    std::string text_;
    bool ended_ = false;
};

} // namespace wakesurf::server
