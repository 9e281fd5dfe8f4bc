#include "server/data/bricks/local_socket.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace wakesurf::server {

using core::Error;

namespace {

tl::unexpected<Error> no_socket(const std::string& what) {
    return core::fail(Error::Code::Io, what + ": " + std::generic_category().message(errno));
}

bool is_ours(int socket) {
    ucred peer{};
    socklen_t size = sizeof(peer);
    return ::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
           peer.uid == ::geteuid();
}

/// Error: Io if the path is longer than the system's addresses.
core::Result<sockaddr_un> address_of(const std::filesystem::path& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string text = path.string();
    if (text.size() >= sizeof(address.sun_path))
        return core::fail(Error::Code::Io,
                          "the path of the socket is too long: it has " +
                              std::to_string(text.size()) + " bytes",
                          "let TMPDIR name a shorter one");
    std::memcpy(address.sun_path, text.data(), text.size());
    return address;
}

} // namespace

core::Result<LocalDoor> LocalDoor::open() {
    std::error_code ignored;
    std::string folder =
        (std::filesystem::temp_directory_path(ignored) / "wakesurf-bricks-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) // 0700
        return no_socket("cannot make a folder for the socket");
    const std::filesystem::path path = std::filesystem::path(folder) / "socket";
    const auto remove = [&] { std::filesystem::remove_all(folder, ignored); };
    const auto address = address_of(path);
    if (!address) {
        remove();
        return tl::unexpected(address.error());
    }
    OpenFile file(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const bool there =
        file.get() >= 0 &&
        ::bind(file.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof(*address)) == 0 &&
        ::chmod(path.c_str(), S_IRUSR | S_IWUSR) == 0 && ::listen(file.get(), 4) == 0;
    if (!there) {
        auto failed = no_socket("cannot make a socket");
        remove();
        return failed;
    }
    return LocalDoor(path, std::move(file));
}

LocalDoor::~LocalDoor() {
    std::error_code ignored;
    if (file_.get() >= 0)
        std::filesystem::remove_all(path_.parent_path(), ignored);
}

std::optional<OpenFile> LocalDoor::let_in() const {
    OpenFile guest(::accept4(file(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (guest.get() < 0 || !is_ours(guest.get()))
        return std::nullopt;
    return guest;
}

core::Result<OpenFile> knock(const std::filesystem::path& door) {
    const auto address = address_of(door);
    if (!address)
        return tl::unexpected(address.error());
    OpenFile file(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
    if (file.get() < 0 ||
        ::connect(file.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof(*address)) != 0)
        return no_socket("cannot reach the server's socket");
    if (!is_ours(file.get()))
        return core::fail(Error::Code::Io, "the server's socket is another user's");
    return file;
}

bool send_message(int socket, std::span<const std::byte> message, int passed) {
    iovec part{const_cast<std::byte*>(message.data()), message.size()};
    msghdr head{};
    head.msg_iov = &part;
    head.msg_iovlen = 1;
    alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))] = {};
    if (passed >= 0) {
        head.msg_control = room;
        head.msg_controllen = sizeof(room);
        cmsghdr* const control = CMSG_FIRSTHDR(&head);
        control->cmsg_level = SOL_SOCKET;
        control->cmsg_type = SCM_RIGHTS;
        control->cmsg_len = CMSG_LEN(sizeof(int));
        std::memcpy(CMSG_DATA(control), &passed, sizeof(int));
    }
    ssize_t sent = -1;
    do
        sent = ::sendmsg(socket, &head, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent == static_cast<ssize_t>(message.size());
}

Received receive_message(int socket, std::span<std::byte> into) {
    iovec part{into.data(), into.size()};
    msghdr head{};
    head.msg_iov = &part;
    head.msg_iovlen = 1;
    alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))] = {};
    head.msg_control = room;
    head.msg_controllen = sizeof(room);
    ssize_t count = -1;
    do
        count = ::recvmsg(socket, &head, MSG_DONTWAIT | MSG_CMSG_CLOEXEC | MSG_TRUNC);
    while (count < 0 && errno == EINTR);
    Received out;
    if (count < 0)
        out.state = errno == EAGAIN ? Received::State::Nothing : Received::State::Closed;
    else if (count == 0)
        out.state = Received::State::Closed;
    else {
        out.state = Received::State::Message;
        out.bytes = static_cast<std::size_t>(count);
    }
    for (cmsghdr* each = CMSG_FIRSTHDR(&head); each != nullptr; each = CMSG_NXTHDR(&head, each))
        if (each->cmsg_level == SOL_SOCKET && each->cmsg_type == SCM_RIGHTS &&
            each->cmsg_len == CMSG_LEN(sizeof(int))) {
            int passed = -1;
            std::memcpy(&passed, CMSG_DATA(each), sizeof(int));
            out.passed = OpenFile(passed);
        }
    return out;
}

} // namespace wakesurf::server
