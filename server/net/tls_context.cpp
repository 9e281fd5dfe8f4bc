#include "server/net/tls_context.hpp"

#include "server/base/private_file.hpp"

#include <boost/asio/ssl/context.hpp>
#include <openssl/ssl.h>
#include <spdlog/spdlog.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

namespace wakesurf::server {

namespace ssl = boost::asio::ssl;
using core::Error;
using core::fail;

namespace {

constexpr std::size_t longest_key = std::size_t{1} << 20;

core::Result<void> readable(const std::filesystem::path& file, const std::string& option) {
    std::error_code ignored;
    const bool plain = std::filesystem::is_regular_file(file, ignored); // a pipe would block
    errno = 0;
    std::ifstream stream(plain || !std::filesystem::exists(file, ignored) ? file : "/dev/null");
    if (stream.peek() != std::ifstream::traits_type::eof())
        return {};
    return fail(Error::Code::Io,
                "the file of " + option +
                    " cannot be read: " + (errno != 0 ? std::strerror(errno) : "it is empty"),
                "give a PEM file that the user of wakesurf can read");
}

/// The ciphers with forward secrecy and authenticated encryption: no RSA key exchange, no CBC.
constexpr const char* tls_1_2_ciphers = "ECDHE+AESGCM:ECDHE+CHACHA20";

/// An encrypted key would ask for its password on the terminal.
std::string no_password(std::size_t, ssl::context::password_purpose) {
    return {};
}

core::Result<std::unique_ptr<ssl::context>> context_from(const std::filesystem::path& certificate,
                                                         const std::filesystem::path& key) {
    if (auto there = readable(certificate, "--tls-cert"); !there)
        return tl::unexpected(there.error());
    const auto secret = read_named_secret(key, longest_key);
    if (!secret)
        return fail(Error::Code::Io, "the file of --tls-key: " + secret.error().message,
                    "give a PEM file that the user of wakesurf can read");
    if (!secret->warning.empty())
        spdlog::warn("event=tls_key_is_readable message=\"the file of --tls-key: {}\" "
                     "hint=\"chmod 600 it\"",
                     secret->warning);
    auto context = std::make_unique<ssl::context>(ssl::context::tls_server);
    SSL_CTX* const native = context->native_handle();
    SSL_CTX_set_min_proto_version(native, TLS1_2_VERSION);
    SSL_CTX_set_options(native, SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION |
                                    SSL_OP_CIPHER_SERVER_PREFERENCE);
    SSL_CTX_set_cipher_list(native, tls_1_2_ciphers);   // those of TLS 1.3 are all of that kind
    SSL_CTX_set_mode(native, SSL_MODE_RELEASE_BUFFERS); // 34 KB less for each idle connection
    boost::system::error_code error;
    context->set_password_callback(no_password, error);
    context->use_certificate_chain_file(certificate.string(), error);
    if (error)
        return fail(Error::Code::Corrupt, "the file of --tls-cert holds no PEM certificate",
                    "it begins with -----BEGIN CERTIFICATE-----");
    context->use_private_key_file(key.string(), ssl::context::pem, error);
    if (error)
        return fail(Error::Code::Corrupt,
                    "the file of --tls-key holds no usable key, or the key of another certificate",
                    "give the unencrypted PEM key the certificate was made with");
    return context;
}

} // namespace

core::Result<std::unique_ptr<TlsContext>> TlsContext::load(std::filesystem::path certificate,
                                                           std::filesystem::path key) {
    std::unique_ptr<TlsContext> out(new TlsContext(std::move(certificate), std::move(key)));
    if (const auto loaded = out->renew(); !loaded)
        return tl::unexpected(loaded.error());
    return out;
}

/// OpenSSL keeps the old context for connections that were made with it.
core::Result<void> TlsContext::renew() {
    auto context = context_from(certificate_, key_);
    if (!context)
        return tl::unexpected(context.error());
    context_ = std::move(*context);
    return {};
}

TlsContext::TlsContext(std::filesystem::path certificate, std::filesystem::path key)
    : certificate_(std::move(certificate)), key_(std::move(key)) {}

TlsContext::~TlsContext() = default;

} // namespace wakesurf::server
