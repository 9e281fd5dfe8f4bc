// A Unix socket between processes of one user on one machine, which preserves message boundaries and passes
// descriptors.
#pragma once

#include "core/base/result.hpp"
#include "server/base/private_file.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace wakesurf::server {

/// A listening socket. Its file (0600) lies in a folder of its own (0700); both are removed with it.
class LocalDoor {
  public:
    /// Opens it. Error: Io.
    static core::Result<LocalDoor> open();
    ~LocalDoor();
    LocalDoor(LocalDoor&& other) noexcept = default;
    LocalDoor& operator=(LocalDoor&& other) = delete;

    const std::filesystem::path& path() const { return path_; }

    int file() const { return file_.get(); }

    /// Accepts a client; empty without one, and for another user's process.
    std::optional<OpenFile> let_in() const;

  private:
    LocalDoor(std::filesystem::path path, OpenFile file)
        : path_(std::move(path)), file_(std::move(file)) {}

    std::filesystem::path path_;
    OpenFile file_;
};

/// Connects. Error: Io; another user's process counts as none.
core::Result<OpenFile> knock(const std::filesystem::path& door);

/// Sends a whole message, at once or not at all. @param passed  a descriptor that goes with it, or -1.
/// Returns false if the peer has closed or does not read.
bool send_message(int socket, std::span<const std::byte> message, int passed = -1);

struct Received {
    enum class State { Message, Nothing, Closed } state = State::Nothing;
    std::size_t bytes = 0; ///< more than fit: the message was too long
    OpenFile passed{};
};

/// Receives a message without waiting.
Received receive_message(int socket, std::span<std::byte> into);

} // namespace wakesurf::server
