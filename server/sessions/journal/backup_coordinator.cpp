#include "server/sessions/journal/backup_coordinator.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

constexpr int socket_poll_ms = 2000; ///< the poll interval for the socket's existence, in ms
constexpr int client_timeout_ms = 5000;
constexpr int longest_hold_ms = 60'000;
constexpr const char* socket_name = "serving.sock";

/// Closes a descriptor.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}

    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return number_; }

    int release() { return std::exchange(number_, -1); }

    void reset(int number) {
        if (number_ >= 0)
            ::close(number_);
        number_ = number;
    }

  private:
    int number_;
};

/// A socket's address holds 107 bytes, a folder's path may be longer: the folder's descriptor names it.
sockaddr_un address_in(int folder) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::snprintf(address.sun_path, sizeof address.sun_path, "/proc/self/fd/%d/%s", folder,
                  socket_name);
    return address;
}

int open_folder(const std::filesystem::path& folder) {
    return ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
}

/// Returns a negative number on failure.
int listen_in(const std::filesystem::path& folder) {
    const Descriptor place(open_folder(folder));
    Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (place.get() < 0 || socket.get() < 0)
        return -1;
    ::unlinkat(place.get(), socket_name, 0); // of a killed server: the folder is ours
    const sockaddr_un address = address_in(place.get());
    ::fchmod(socket.get(), 0600); // the mode of the file
    if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::fchmodat(place.get(), socket_name, 0600, 0) != 0 || ::listen(socket.get(), 4) != 0)
        return -1;
    return socket.release();
}

void send_line(int socket, const std::string& line) {
    static_cast<void>(::send(socket, line.data(), line.size(), MSG_NOSIGNAL));
}

std::string read_line(int socket) {
    std::string line;
    for (char byte = 0; line.size() < 500 && ::recv(socket, &byte, 1, 0) == 1 && byte != '\n';)
        line += byte;
    return line;
}

} // namespace

BackupCoordinator::BackupCoordinator(std::filesystem::path folder, Services services)
    : folder_(std::move(folder)), services_(std::move(services)), ended_(::eventfd(0, EFD_CLOEXEC)),
      thread_([this] { work(); }) {}

BackupCoordinator::~BackupCoordinator() {
    ::eventfd_write(ended_, 1);
    thread_.join();
    ::close(ended_);
    std::error_code ignored;
    std::filesystem::remove(folder_ / socket_name, ignored);
}

/// Returns false at the end; `descriptor` may be -1, and may not be ready.
bool BackupCoordinator::wait_for(int descriptor, int milliseconds) const {
    std::array<pollfd, 2> wanted{pollfd{ended_, POLLIN, 0}, pollfd{descriptor, POLLIN, 0}};
    ::poll(wanted.data(), wanted.size(), milliseconds);
    return wanted[0].revents == 0;
}

void BackupCoordinator::work() {
    Descriptor listener(-1);
    do {
        // The folder may have been deleted, and made again by the journal.
        if (listener.get() < 0 || ::access((folder_ / socket_name).c_str(), F_OK) != 0)
            listener.reset(listen_in(folder_));
        if (listener.get() < 0)
            continue;
        pollfd coming{listener.get(), POLLIN, 0};
        if (::poll(&coming, 1, 0) <= 0)
            continue;
        const Descriptor asker(::accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC));
        if (asker.get() >= 0)
            serve(asker.get());
    } while (wait_for(listener.get(), socket_poll_ms));
}

void BackupCoordinator::serve(int asker) const {
    const timeval patient{client_timeout_ms / 1000, 0};
    ::setsockopt(asker, SOL_SOCKET, SO_RCVTIMEO, &patient, sizeof patient);
    ::setsockopt(asker, SOL_SOCKET, SO_SNDTIMEO, &patient, sizeof patient);
    if (read_line(asker) != "hold")
        return send_line(asker, "error this server does not know this request\n");
    const auto held = services_.hold();
    if (!held)
        return send_line(asker, "error " + held.error().message + "\n");
    send_line(asker, "ok\n");
    wait_for(asker, longest_hold_ms);
    pollfd said{asker, POLLIN, 0};
    const bool in_time = ::poll(&said, 1, 0) > 0;
    const bool whole = services_.release();
    send_line(asker, in_time && whole ? "whole\n" : "changed\n");
}

core::Result<BackupLock> BackupLock::ask(const std::filesystem::path& folder) {
    const Descriptor place(open_folder(folder));
    BackupLock hold(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const sockaddr_un address = address_in(place.get());
    if (place.get() < 0 || hold.socket_ < 0 ||
        ::connect(hold.socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return fail(Error::Code::NotFound,
                    "the server that keeps its sessions there does not answer",
                    "run this command as the server's user, or stop the server first");
    const timeval patient{30, 0};
    ::setsockopt(hold.socket_, SOL_SOCKET, SO_RCVTIMEO, &patient, sizeof patient);
    send_line(hold.socket_, "hold\n");
    const std::string answer = read_line(hold.socket_);
    if (answer == "ok")
        return hold;
    return fail(Error::Code::Io,
                answer.starts_with("error ") ? answer.substr(6)
                                             : "the server that keeps its sessions there is busy",
                "try again, or stop it first");
}

BackupLock::~BackupLock() {
    if (socket_ >= 0)
        ::close(socket_);
}

BackupLock::BackupLock(BackupLock&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

bool BackupLock::finish() {
    send_line(socket_, "done\n");
    return read_line(socket_) == "whole";
}

} // namespace wakesurf::server
