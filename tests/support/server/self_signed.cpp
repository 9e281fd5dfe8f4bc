#include "tests/support/server/self_signed.hpp"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace wakesurf::tests {

namespace {

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

void check(bool good) {
    if (!good)
        throw std::runtime_error("OpenSSL made no certificate");
}

Owned<std::FILE> open_file(const std::filesystem::path& path) {
    Owned<std::FILE> file(std::fopen(path.c_str(), "w"),
                          [](std::FILE* each) { std::fclose(each); });
    check(file != nullptr);
    return file;
}

} // namespace

void write_self_signed(const std::filesystem::path& certificate, const std::filesystem::path& key) {
    const Owned<EVP_PKEY> pair(EVP_EC_gen("P-256"), EVP_PKEY_free);
    const Owned<X509> made(X509_new(), X509_free);
    check(pair && made);
    X509_set_version(made.get(), X509_VERSION_3);
    ASN1_INTEGER_set(X509_get_serialNumber(made.get()), 1);
    X509_gmtime_adj(X509_getm_notBefore(made.get()), -60);
    X509_gmtime_adj(X509_getm_notAfter(made.get()), 3600);
    X509_NAME* const name = X509_get_subject_name(made.get());
    const auto* const host = reinterpret_cast<const unsigned char*>("localhost");
    check(X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, host, -1, -1, 0) == 1);
    X509_set_issuer_name(made.get(), name);
    X509_set_pubkey(made.get(), pair.get());
    const Owned<X509_EXTENSION> names(
        X509V3_EXT_conf_nid(nullptr, nullptr, NID_subject_alt_name, "DNS:localhost,IP:127.0.0.1"),
        X509_EXTENSION_free);
    check(names && X509_add_ext(made.get(), names.get(), -1) == 1);
    check(X509_sign(made.get(), pair.get(), EVP_sha256()) > 0);
    check(PEM_write_X509(open_file(certificate).get(), made.get()) == 1);
    check(PEM_write_PrivateKey(open_file(key).get(), pair.get(), nullptr, nullptr, 0, nullptr,
                               nullptr) == 1);
}

} // namespace wakesurf::tests
