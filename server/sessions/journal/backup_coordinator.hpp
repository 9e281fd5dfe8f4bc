// A Unix-domain socket (0600) in the state folder, by which other programs of the same user reach a running
// server. It grants one request: the file stays unchanged while it is copied.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <thread>

namespace wakesurf::server {

/// Answers the line `hold` by `ok`, or by `error REASON`. The client's next bytes, or its leaving, end the
/// hold, answered by `whole` if the file was unchanged all the time, else by `changed`. One client at a time,
/// each for a minute at most.
class BackupCoordinator {
  public:
    struct Services {
        std::function<core::Result<void>()> hold;
        std::function<bool()> release; ///< returns whether the file was unchanged
    };

    /// The services are called by a thread of its own. Without a socket, in a folder that takes none, copies
    /// need a server that has ended.
    BackupCoordinator(std::filesystem::path folder, Services services);
    ~BackupCoordinator();
    BackupCoordinator(const BackupCoordinator&) = delete;
    BackupCoordinator& operator=(const BackupCoordinator&) = delete;

  private:
    void work();
    void serve(int asker) const;
    bool wait_for(int descriptor, int milliseconds) const;

    std::filesystem::path folder_;
    Services services_;
    int ended_; ///< an eventfd
    std::thread thread_;
};

/// Keeps a server's file unchanged as long as this lives.
class BackupLock {
  public:
    /// Asks for it. Error: NotFound without a server; Io with its reason.
    static core::Result<BackupLock> ask(const std::filesystem::path& folder);

    ~BackupLock();
    BackupLock(BackupLock&& other) noexcept;
    BackupLock& operator=(BackupLock&&) = delete;

    /// Ends it; returns whether the file was unchanged until now.
    bool finish();

  private:
    explicit BackupLock(int socket) : socket_(socket) {}

    int socket_;
};

} // namespace wakesurf::server
