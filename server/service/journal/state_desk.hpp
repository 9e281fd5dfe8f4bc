// The place in the state folder where other programs of the same user reach a server that runs: a
// Unix-domain socket (0600). It grants one thing, that the file is left alone while somebody copies it.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <thread>

namespace wakesurf::server {

/// `hold\n` is answered by `ok\n`, or `error REASON\n`; what the asker sends then, or its leaving, ends it,
/// answered by `whole\n` where the file was left alone all the time, else `changed\n`. One asker at a time,
/// each for a minute at most.
class StateDesk {
  public:
    struct Services {
        std::function<core::Result<void>()> hold;
        std::function<bool()> release; ///< whether the file was left alone
    };

    /// Called by a thread of its own. A folder that takes no socket is done without: copies need a server
    /// that has ended then.
    StateDesk(std::filesystem::path folder, Services services);
    ~StateDesk();
    StateDesk(const StateDesk&) = delete;
    StateDesk& operator=(const StateDesk&) = delete;

  private:
    void work();
    void serve(int asker) const;
    bool wait_for(int descriptor, int milliseconds) const;

    std::filesystem::path folder_;
    Services services_;
    int ended_; ///< an eventfd
    std::thread thread_;
};

/// A server's file left alone, as long as this lives.
class StateHold {
  public:
    /// Error: NotFound where no server answers; Io with its reason.
    static core::Result<StateHold> ask(const std::filesystem::path& folder);

    ~StateHold();
    StateHold(StateHold&& other) noexcept;
    StateHold& operator=(StateHold&&) = delete;

    /// Lets go of it; whether it was left alone until now.
    bool finish();

  private:
    explicit StateHold(int socket) : socket_(socket) {}

    int socket_;
};

} // namespace wakesurf::server
