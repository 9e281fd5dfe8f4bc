#include "server/net/token_file.hpp"

#include "server/base/private_file.hpp"

#include <algorithm>
#include <fstream>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

core::Result<std::string>
make(const std::filesystem::path& file, Entropy& entropy, const std::string& name) {
    std::string token = fresh_token(entropy);
    if (auto written = write_private_file(file, token + "\n"); !written)
        return fail(Error::Code::Io, name + ": " + written.error().message, written.error().hint);
    return token;
}

} // namespace

std::string fresh_token(Entropy& entropy) {
    return random_hex(entropy, 32);
}

core::Result<std::string>
secret_from(const std::filesystem::path& file, Entropy& entropy, const std::string& name) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return make(file, entropy, name);
    std::ifstream stream(file);
    std::string secret;
    if (!std::getline(stream, secret))
        return fail(Error::Code::Io, name + " is empty or cannot be read",
                    "delete the file to get a new one");
    const auto printable = [](char c) { return c > ' ' && c < 0x7f; };
    if (secret.size() < 32 || secret.size() > 512 ||
        !std::all_of(secret.begin(), secret.end(), printable))
        return fail(Error::Code::Corrupt, name + " must be 32 to 512 characters without spaces",
                    "delete the file to get a new one");
    return secret;
}

core::Result<std::string> new_token_in(const std::filesystem::path& file, Entropy& entropy) {
    return make(file, entropy, "the token file");
}

} // namespace wakesurf::server
