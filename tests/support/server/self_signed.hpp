// A certificate and its key for 127.0.0.1 and localhost, made for one test run and good for an hour.
#pragma once

#include <filesystem>

namespace wakesurf::tests {

/// Writes PEM files. Throws if OpenSSL fails.
void write_self_signed(const std::filesystem::path& certificate, const std::filesystem::path& key);

} // namespace wakesurf::tests
