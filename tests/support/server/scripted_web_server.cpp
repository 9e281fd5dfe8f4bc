#include "tests/support/server/scripted_web_server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace wakesurf::tests {

ScriptedWebServer::ScriptedWebServer(std::function<Reply(const std::string&)> answer)
    : answer_(std::move(answer)), listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listening_, any, length) != 0 || ::listen(listening_, 128) != 0 ||
        ::getsockname(listening_, any, &length) != 0)
        throw std::runtime_error("cannot listen on loopback");
    port_ = ntohs(address.sin_port);
    accepting_ = std::thread([this] { accept_all(); });
}

ScriptedWebServer::~ScriptedWebServer() {
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
        for (const int each : connections_)
            ::shutdown(each, SHUT_RDWR);
    }
    ::shutdown(listening_, SHUT_RDWR);
    accepting_.join();
    for (auto& each : threads_)
        each.join();
    for (const int each : connections_)
        ::close(each);
    ::close(listening_);
}

std::string ScriptedWebServer::address(const std::string& path) const {
    return "http://127.0.0.1:" + std::to_string(port_) + "/" + path;
}

std::size_t ScriptedWebServer::connections() const {
    const std::scoped_lock lock(mutex_);
    return connections_.size();
}

void ScriptedWebServer::accept_all() {
    for (;;) {
        const int connection = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
        const std::scoped_lock lock(mutex_);
        if (connection < 0)
            return;
        connections_.push_back(connection);
        if (ending_) // the destructor has shut down those before
            ::shutdown(connection, SHUT_RDWR);
        const int on = 1;
        ::setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        threads_.emplace_back([this, connection] { serve(connection); });
    }
}

void ScriptedWebServer::serve(int connection) {
    std::string got;
    std::array<char, 4096> bytes{};
    for (;;) {
        const auto end = got.find("\r\n\r\n");
        if (end == std::string::npos) {
            const ssize_t more = ::recv(connection, bytes.data(), bytes.size(), 0);
            if (more <= 0)
                return;
            got.append(bytes.data(), static_cast<std::size_t>(more));
            continue;
        }
        const Reply reply = answer_(got.substr(0, end + 4));
        got.erase(0, end + 4);
        for (std::size_t sent = 0; sent < reply.bytes.size();) {
            const ssize_t now = ::send(connection, reply.bytes.data() + sent,
                                       reply.bytes.size() - sent, MSG_NOSIGNAL);
            if (now <= 0)
                return;
            sent += static_cast<std::size_t>(now);
        }
        while (reply.silent && ::recv(connection, bytes.data(), bytes.size(), 0) > 0) {
        }
        if (reply.cut || reply.silent)
            ::shutdown(connection, SHUT_RDWR);
    }
}

} // namespace wakesurf::tests
