// The token of the server, and other secrets that it keeps, in files that only its user can read.
#pragma once

#include "core/base/result.hpp"
#include "server/service/base/entropy.hpp"
#include "server/service/base/private_file.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// 256 random bits as 64 hexadecimal digits.
std::string fresh_token(Entropy& entropy);

/// A secret of the server's own; where there is no such file, one is made (0600). Error: Io; Corrupt, the file does not hold 32 to 512
/// printable characters.
/// @param name  what it is, for people
core::Result<std::string>
own_secret(const std::filesystem::path& file, Entropy& entropy, const std::string& name);

/// The file that a person keeps the token in. While a server uses it, it is locked, so that no other changes it meanwhile.
class TokenFile {
  public:
    explicit TokenFile(std::filesystem::path file) : file_(std::move(file)) {}

    /// The token in it, and with `change` a fresh one that is not in it yet; one is made, or will be, where there is no such file. Where
    /// others could read it, that is mended if it is this user's, and the log says so. Error: as own_secret; OverLimit where it is to be
    /// changed and another server uses it.
    core::Result<std::string> token(Entropy& entropy, bool change);

    /// Puts the fresh token into it. Does nothing where it was not to be changed. Error: Io.
    core::Result<void> keep();

  private:
    core::Result<std::string> read() const;
    core::Result<void> lock(bool alone);

    std::filesystem::path file_;
    OpenFile locked_;
    std::string fresh_;
};

} // namespace wakesurf::server
