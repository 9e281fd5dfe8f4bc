// The token of the server, and other secrets that it keeps, in files that only its user can read.
#pragma once

#include "core/base/result.hpp"
#include "server/base/private_file.hpp"
#include "server/base/secret.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// Returns 256 random bits as 64 hexadecimal digits.
std::string fresh_token(Entropy& entropy);

/// Reads a secret of the server's own; makes the file (0600) if it is missing. Error: Io; Corrupt, the file
/// does not hold 32 to 512 printable characters.
/// @param name  of the secret, for messages
core::Result<std::string>
own_secret(const std::filesystem::path& file, Entropy& entropy, const std::string& name);

/// A file in which a user keeps the token. A running server locks it, so that no other changes it meanwhile.
class TokenFile {
  public:
    explicit TokenFile(std::filesystem::path file) : file_(std::move(file)) {}

    /// Returns the token; with `change` a fresh one that is not in the file yet; a missing file is, or will
    /// be, made. If others can read the file and it is this user's, its mode is corrected, with a line in the
    /// log. Error: as own_secret; OverLimit to change it while another server uses it.
    core::Result<std::string> token(Entropy& entropy, bool change);

    /// Writes the fresh token; does nothing without `change`. Error: Io.
    core::Result<void> keep();

  private:
    core::Result<std::string> read() const;
    core::Result<void> lock(bool alone);

    std::filesystem::path file_;
    OpenFile locked_;
    std::string fresh_;
};

} // namespace wakesurf::server
