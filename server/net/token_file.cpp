#include "server/net/token_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace wakesurf::server {

namespace {

using core::Error;
using core::fail;

core::Result<std::string> make(const std::filesystem::path& file, Entropy& entropy) {
    const std::string token = fresh_token(entropy);
    const std::string line = token + "\n";
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor < 0)
        return fail(Error::Code::Io,
                    std::string("the token file cannot be created: ") + std::strerror(errno),
                    "give --token-file a path that can be written");
    const bool written =
        ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    if ((::close(descriptor) != 0) || !written)
        return fail(Error::Code::Io, "the token file cannot be written", "free some disk space");
    return token;
}

} // namespace

std::string fresh_token(Entropy& entropy) {
    return random_hex(entropy, 32);
}

core::Result<std::string> token_from(const std::filesystem::path& file, Entropy& entropy) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return make(file, entropy);
    std::ifstream stream(file);
    std::string token;
    if (!std::getline(stream, token))
        return fail(Error::Code::Io, "the token file is empty or cannot be read",
                    "delete it to get a new one");
    const auto printable = [](char c) { return c > ' ' && c < 0x7f; };
    if (token.size() < 32 || token.size() > 512 ||
        !std::all_of(token.begin(), token.end(), printable))
        return fail(Error::Code::Corrupt,
                    "the token in the token file must be 32 to 512 characters without spaces",
                    "delete the file to get a new one");
    return token;
}

} // namespace wakesurf::server
