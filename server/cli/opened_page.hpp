// The page, opened in a browser of this machine; and what to type on another one, where the person sits there.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// What opens a page on this display, word by word, `page` among them: $BROWSER's first program that is there, else xdg-open. Nothing where
/// there is no display, or only that of the machine's own screen while the person came by ssh.
std::vector<std::string> browser_command(const std::string& page);

/// For who came by ssh: the line that makes the server's port one of their own machine.
std::optional<std::string> tunnel_command(const std::string& host, std::uint16_t port);

/// A file for this user alone, whose page leads to the link: the link has the token, and every user of a machine can read the words
/// that a program was started with. It is there as long as this is.
class OpenedPage {
  public:
    /// Error: NotFound, there is no browser to open it in; Io.
    static core::Result<OpenedPage> open(const std::string& link);

    ~OpenedPage();

    OpenedPage(OpenedPage&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}

    OpenedPage& operator=(OpenedPage&&) = delete;

  private:
    explicit OpenedPage(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_; ///< empty: moved from
};

} // namespace wakesurf::server
