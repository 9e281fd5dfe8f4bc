#include "tests/support/server/raw_socket.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace wakesurf::tests {

RawSocket::RawSocket(std::uint16_t port)
    : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        throw std::runtime_error("cannot connect to the server under test");
    const int on = 1; // or two small writes in a row wait 40 ms for an acknowledgement
    ::setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

RawSocket::~RawSocket() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

RawSocket::RawSocket(RawSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), kept_(std::move(other.kept_)) {}

void RawSocket::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent <= 0)
            return; // the other side has closed; what it said before is still to be read
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

std::string RawSocket::receive(std::chrono::milliseconds patience) {
    if (!kept_.empty())
        return std::exchange(kept_, {});
    pollfd wait{descriptor_, POLLIN, 0};
    if (::poll(&wait, 1, static_cast<int>(patience.count())) == 0)
        throw std::runtime_error("the server under test said nothing for too long");
    std::string bytes(std::size_t{64} << 10, '\0');
    const ssize_t got = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
}

std::string RawSocket::receive_until(std::string_view end) {
    std::string bytes;
    for (;;) {
        const std::string more = receive();
        if (more.empty())
            return bytes;
        bytes += more;
        if (const auto at = bytes.find(end); at != std::string::npos) {
            kept_ = bytes.substr(at + end.size());
            bytes.resize(at + end.size());
            return bytes;
        }
    }
}

std::string RawSocket::receive_exactly(std::size_t count) {
    std::string bytes;
    while (bytes.size() < count) {
        const std::string more = receive();
        if (more.empty())
            return {};
        bytes += more;
    }
    kept_ = bytes.substr(count);
    bytes.resize(count);
    return bytes;
}

bool RawSocket::readable_within(std::chrono::milliseconds patience) const {
    pollfd wait{descriptor_, POLLIN, 0};
    return !kept_.empty() || ::poll(&wait, 1, static_cast<int>(patience.count())) > 0;
}

bool RawSocket::closed_within(std::chrono::milliseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    kept_.clear();
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now());
        pollfd wait{descriptor_, POLLIN, 0};
        if (left.count() <= 0 || ::poll(&wait, 1, static_cast<int>(left.count())) == 0)
            return false;
        if (receive().empty())
            return true;
    }
}

void RawSocket::reset() {
    const linger hard{1, 0};
    ::setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
    ::close(std::exchange(descriptor_, -1));
}

std::string HttpReply::header(std::string_view name) const {
    for (const auto& [key, value] : headers)
        if (key == name)
            return value;
    return {};
}

HttpReply read_reply(RawSocket& socket, bool head) {
    HttpReply reply;
    const std::string text = socket.receive_until("\r\n\r\n");
    if (text.size() < 12)
        return reply;
    reply.status = std::stoi(text.substr(9, 3));
    for (std::size_t at = text.find("\r\n") + 2; at + 2 < text.size();) {
        const auto end = text.find("\r\n", at);
        const auto colon = text.find(':', at);
        std::string name = text.substr(at, colon - at);
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return std::tolower(c); });
        reply.headers.emplace_back(name, text.substr(colon + 2, end - colon - 2));
        at = end + 2;
    }
    const std::string length = reply.header("content-length");
    if (!head && !length.empty())
        reply.body = socket.receive_exactly(std::stoul(length));
    return reply;
}

HttpReply http(std::uint16_t port,
               std::string_view method,
               std::string_view target,
               Headers headers,
               std::string_view body) {
    std::string text = std::string(method) + " " + std::string(target) + " HTTP/1.1\r\n";
    const bool host = std::any_of(headers.begin(), headers.end(),
                                  [](const auto& each) { return each.first == "Host"; });
    if (!host)
        headers.emplace_back("Host", "127.0.0.1:" + std::to_string(port));
    if (!body.empty() || method == "POST")
        headers.emplace_back("Content-Length", std::to_string(body.size()));
    for (const auto& [name, value] : headers)
        text += name + ": " + value + "\r\n";
    RawSocket socket(port);
    socket.send(text + "\r\n" + std::string(body));
    return read_reply(socket, method == "HEAD");
}

} // namespace wakesurf::tests
