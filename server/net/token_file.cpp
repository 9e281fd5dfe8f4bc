#include "server/net/token_file.hpp"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

constexpr std::size_t shortest = 32;
constexpr std::size_t longest = 512;
const std::string token_name = "the token file";

tl::unexpected<Error> named(const std::string& name, const Error& error) {
    return fail(error.code, name + ": " + error.message, error.hint);
}

core::Result<std::string>
make(const std::filesystem::path& file, Entropy& entropy, const std::string& name) {
    std::string token = fresh_token(entropy);
    if (auto written = write_private_file(file, token + "\n"); !written)
        return named(name, written.error());
    return token;
}

/// Returns the first line.
core::Result<std::string> secret_in(const std::string& text, const std::string& name) {
    const std::string secret = text.substr(0, text.find('\n'));
    const auto printable = [](char c) { return c > ' ' && c < 0x7f; };
    if (secret.size() < shortest || secret.size() > longest ||
        !std::all_of(secret.begin(), secret.end(), printable))
        return fail(Error::Code::Corrupt, name + " must be 32 to 512 characters without spaces",
                    "delete the file to get a new one");
    return secret;
}

} // namespace

std::string fresh_token(Entropy& entropy) {
    return random_hex(entropy, 32);
}

core::Result<std::string>
own_secret(const std::filesystem::path& file, Entropy& entropy, const std::string& name) {
    const auto text = read_private_file(file, 2 * longest);
    if (!text && text.error().code == Error::Code::NotFound)
        return make(file, entropy, name);
    if (!text)
        return named(name, text.error());
    return secret_in(*text, name);
}

core::Result<std::string> TokenFile::token(Entropy& entropy, bool change) {
    auto old = read();
    const bool none = !old && old.error().code == Error::Code::NotFound;
    if (!old && !none && !(change && old.error().code == Error::Code::Corrupt))
        return named(token_name, old.error());
    if (change) {
        if (auto alone = lock(true); !alone)
            return tl::unexpected(alone.error());
        fresh_ = fresh_token(entropy);
        return fresh_;
    }
    auto token = none ? make(file_, entropy, token_name) : std::move(old);
    if (auto held = lock(false); token && !held)
        return tl::unexpected(held.error());
    return token;
}

core::Result<void> TokenFile::keep() {
    if (fresh_.empty())
        return {};
    std::error_code none; // a symbolic link stays one
    const auto behind = std::filesystem::canonical(file_, none);
    if (auto written = write_private_file(none ? file_ : behind, fresh_ + "\n"); !written)
        return named(token_name, written.error());
    return lock(false);
}

core::Result<std::string> TokenFile::read() const {
    const auto secret = read_named_secret(file_, 2 * longest);
    if (!secret)
        return tl::unexpected(secret.error());
    if (!secret->warning.empty()) {
        std::error_code not_ours;
        std::filesystem::permissions(file_, std::filesystem::perms{0077},
                                     std::filesystem::perm_options::remove, not_ours);
        spdlog::warn("event=token_was_readable message=\"the token file: {}{}\" hint=\"change the "
                     "token with --new-token if someone may have read it\"",
                     secret->warning, not_ours ? "" : "; now it is this user's alone");
    }
    return secret_in(secret->text, "the token in the token file");
}

/// Does nothing if the file system has no locks.
core::Result<void> TokenFile::lock(bool alone) {
    OpenFile file(::open(file_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.get() >= 0 && ::flock(file.get(), (alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0 &&
        errno == EWOULDBLOCK)
        return fail(Error::Code::OverLimit,
                    alone ? "the token file is in use by another server, which would keep its token"
                          : "the token in the token file is being changed by another server",
                    alone ? "stop it first, or name another file with --token-file" : "try again");
    locked_ = std::move(file);
    return {};
}

} // namespace wakesurf::server
