#include "tests/support/server/nginx.hpp"

#include "server/data/child_process.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>

namespace wakesurf::tests {

namespace {

constexpr const char* program = "/usr/sbin/nginx";

/// Returns a port without a listener.
std::uint16_t unused_port() {
    const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    const bool got = ::bind(probe, any, length) == 0 && ::getsockname(probe, any, &length) == 0;
    ::close(probe);
    if (!got)
        throw std::runtime_error("loopback has no port left");
    return ntohs(address.sin_port);
}

} // namespace

Nginx::Nginx(const std::filesystem::path& folder, const std::string& more) {
    const std::string own = own_.path().string();
    std::string words;
    for (int tries = 0; tries < 20; ++tries) { // another process may take the port first
        port_ = unused_port();
        std::string temporary;
        for (const char* each : {"client_body", "proxy", "fastcgi", "uwsgi", "scgi"})
            temporary += std::string(each) + "_temp_path " + own + "/" + each + ";\n";
        write_file(own_ / "nginx.conf",
                   std::string(::getuid() == 0 ? "user root;\n" : "") +
                       "worker_processes 1;\npid " + own + "/pid;\nerror_log " + own +
                       "/errors;\nevents { worker_connections 512; }\nhttp {\naccess_log off;\n" +
                       "default_type application/octet-stream;\n" + temporary +
                       "server {\nlisten 127.0.0.1:" + std::to_string(port_) + ";\nroot " +
                       folder.string() + ";\n" + more + "\n}\n}\n");
        const auto run = server::run_child(
            program, {"-p", own, "-c", own + "/nginx.conf", "-e", own + "/errors"}, 0,
            [](std::string_view) {}, {});
        if (!run)
            throw std::runtime_error("nginx is not installed: " + run.error().message);
        if (run->exit_status == 0 && run->signal == 0) { // it listens, and has left the foreground
            process_ = std::stoi(read_file(own_ / "pid"));
            return;
        }
        words = run->errors;
    }
    throw std::runtime_error("nginx does not begin: " + words);
}

Nginx::~Nginx() {
    ::kill(process_, SIGTERM);
}

} // namespace wakesurf::tests
