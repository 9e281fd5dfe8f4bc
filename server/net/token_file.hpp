// The token's source: a fresh random one for this run, or a file only the user can read.
#pragma once

#include "core/base/result.hpp"
#include "server/base/entropy.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// 256 random bits as hexadecimal digits.
std::string fresh_token(Entropy& entropy);

/// The first line of `file`; a file that is not there is made, readable by its owner only, with a fresh token.
/// Error: Io; Corrupt for a token shorter than 32 or longer than 512 characters or with blanks.
core::Result<std::string> token_from(const std::filesystem::path& file, Entropy& entropy);

} // namespace wakesurf::server
