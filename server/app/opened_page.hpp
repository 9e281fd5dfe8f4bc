// Opens the page in a browser of this machine, or tells what to type on another one, for a user at that
// machine.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Returns the command that opens a page on this display, word by word, with `page` among them: $BROWSER's
/// first installed program, else xdg-open. Empty without a display, or if only the machine's own screen is
/// there and the user came by ssh.
std::vector<std::string> browser_command(const std::string& page);

/// Returns, for a user who came by ssh, the line that forwards the server's port to their own machine.
std::optional<std::string> tunnel_command(const std::string& host, std::uint16_t port);

/// A file for this user alone, whose page leads to the link: the link has the token, and every user of a
/// machine can read the arguments of a program. The file exists as long as this.
class OpenedPage {
  public:
    /// Opens the page. Error: NotFound without a browser; Io.
    static core::Result<OpenedPage> open(const std::string& link);

    ~OpenedPage();

    OpenedPage(OpenedPage&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}

    OpenedPage& operator=(OpenedPage&&) = delete;

  private:
    explicit OpenedPage(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_; ///< empty: moved from
};

} // namespace wakesurf::server
