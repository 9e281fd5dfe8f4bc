#include "tests/support/server/tls_socket.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace wakesurf::tests {

struct TlsSocket::State {
    int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    SSL_CTX* context = SSL_CTX_new(TLS_client_method());
    SSL* ssl = nullptr;

    ~State() {
        SSL_free(ssl);
        SSL_CTX_free(context);
        ::close(descriptor);
    }
};

TlsSocket::TlsSocket(std::uint16_t port,
                     const std::filesystem::path& trusted,
                     int newest,
                     const std::string& ciphers)
    : state_(std::make_unique<State>()) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{180, 0}; // like RawSocket
    ::setsockopt(state_->descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    if (::connect(state_->descriptor, reinterpret_cast<const sockaddr*>(&address),
                  sizeof address) != 0)
        throw std::runtime_error("cannot connect to the server under test");
    SSL_CTX_set_min_proto_version(state_->context, TLS1_VERSION);
    SSL_CTX_set_max_proto_version(state_->context, newest);
    if (newest != 0) // or this side would refuse what the server is to refuse
        SSL_CTX_set_security_level(state_->context, 0);
    if (!ciphers.empty())
        SSL_CTX_set_cipher_list(state_->context, ciphers.c_str());
    SSL_CTX_load_verify_locations(state_->context, trusted.c_str(), nullptr);
    SSL_CTX_set_verify(state_->context, SSL_VERIFY_PEER, nullptr);
    state_->ssl = SSL_new(state_->context);
    SSL_set1_host(state_->ssl, "localhost");
    SSL_set_fd(state_->ssl, state_->descriptor);
    connected_ = SSL_connect(state_->ssl) == 1;
}

TlsSocket::~TlsSocket() = default;

std::string TlsSocket::version() const {
    return SSL_get_version(state_->ssl);
}

void TlsSocket::send(std::string_view bytes) {
    SSL_write(state_->ssl, bytes.data(), static_cast<int>(bytes.size()));
}

std::string TlsSocket::receive() {
    std::string bytes(std::size_t{16} << 10, '\0');
    const int got = SSL_read(state_->ssl, bytes.data(), static_cast<int>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max(got, 0)));
    return bytes;
}

std::string TlsSocket::receive_until(std::string_view end) {
    std::string text;
    for (;;) {
        const std::string more = receive();
        if (more.empty())
            return text;
        text += more;
        if (const auto at = text.find(end); !end.empty() && at != std::string::npos)
            return text.substr(0, at + end.size());
    }
}

bool TlsSocket::ended_in_order() const {
    return (SSL_get_shutdown(state_->ssl) & SSL_RECEIVED_SHUTDOWN) != 0;
}

std::string https(std::uint16_t port,
                  const std::filesystem::path& trusted,
                  std::string_view method,
                  std::string_view target,
                  const Headers& headers,
                  std::string_view body) {
    std::string text =
        std::string(method) + " " + std::string(target) +
        " HTTP/1.1\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) + "\r\n";
    bool host = false;
    for (const auto& [name, value] : headers) {
        host = host || name == "Host";
        text += name + ": " + value + "\r\n";
    }
    if (!host)
        text += "Host: 127.0.0.1:" + std::to_string(port) + "\r\n";
    TlsSocket socket(port, trusted);
    socket.send(text + "\r\n" + std::string(body));
    return socket.receive_until("");
}

} // namespace wakesurf::tests
