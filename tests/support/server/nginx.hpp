// A folder on a real web server, nginx, on loopback.
#pragma once

#include "tests/support/temporary_folder.hpp"

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace wakesurf::tests {

class Nginx {
  public:
    /// Waits until it listens. Throws if it is not installed. @param more  lines of its `server`
    explicit Nginx(const std::filesystem::path& folder, const std::string& more = "");
    ~Nginx();
    Nginx(const Nginx&) = delete;
    Nginx& operator=(const Nginx&) = delete;

    std::uint16_t port() const { return port_; }

  private:
    TemporaryFolder own_; ///< what it writes
    std::uint16_t port_ = 0;
    pid_t process_ = -1;
};

} // namespace wakesurf::tests
