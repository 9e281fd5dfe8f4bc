#include "server/base/sha256.hpp"

#include <openssl/evp.h>

#include <stdexcept>

namespace wakesurf::server {

namespace {

EVP_MD_CTX* of_openssl(void* context) {
    return static_cast<EVP_MD_CTX*>(context);
}

void require(int done) {
    if (done != 1)
        throw std::runtime_error("the system has no SHA-256");
}

} // namespace

void Sha256::Free::operator()(void* context) const {
    EVP_MD_CTX_free(of_openssl(context));
}

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
    require(context_ ? EVP_DigestInit_ex(of_openssl(context_.get()), EVP_sha256(), nullptr) : 0);
}

void Sha256::add(std::span<const std::byte> bytes) {
    require(EVP_DigestUpdate(of_openssl(context_.get()), bytes.data(), bytes.size()));
}

Digest Sha256::digest() {
    Digest out{};
    require(EVP_DigestFinal_ex(of_openssl(context_.get()),
                               reinterpret_cast<unsigned char*>(out.data()), nullptr));
    return out;
}

std::string digest_text(const Digest& digest) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::byte each : digest) {
        text += digits[std::to_integer<unsigned>(each >> 4)];
        text += digits[std::to_integer<unsigned>(each & std::byte{15})];
    }
    return text;
}

} // namespace wakesurf::server
