// The token of the server, and other secrets that it keeps, in files that only its user can read.
#pragma once

#include "core/base/result.hpp"
#include "server/base/entropy.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// 256 random bits as 64 hexadecimal digits.
std::string fresh_token(Entropy& entropy);

/// The secret in the file; where there is no such file, one is made (0600). Error: Io; Corrupt, the file does not hold
/// 32 to 512 printable characters.
/// @param name  what it is, for people
core::Result<std::string>
secret_from(const std::filesystem::path& file, Entropy& entropy, const std::string& name);

/// Puts a fresh token into the file (0600), whatever it held. Error: Io.
core::Result<std::string> new_token_in(const std::filesystem::path& file, Entropy& entropy);

} // namespace wakesurf::server
