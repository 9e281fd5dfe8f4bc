#include "server/import/store_writer.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace wakesurf::server {

using core::Error;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view lock_name = "store.lock";

// What a signal handler may touch: the name of the unfinished file, valid while `unfinished` is set.
std::array<char, 4096> part_name{};
std::atomic<bool> unfinished{false};

extern "C" void end_now(int) {
    if (unfinished.load())
        ::unlink(part_name.data());
    constexpr std::string_view message =
        "wakesurf-import: interrupted; the same command goes on where this one ended\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(1);
}

tl::unexpected<Error> failure(const std::string& what) {
    const int error = errno;
    return core::fail(Error::Code::Io, what + ": " + std::generic_category().message(error));
}

bool written_by_an_importer(const std::string& name) {
    return name == protocol::manifest_file_name || name == protocol::mask_file_name ||
           (name.starts_with("velocity_") && name.ends_with(".f32")) || name.ends_with(".part");
}

core::Result<void> check_contents(const fs::path& folder) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name != lock_name && !written_by_an_importer(name))
            return core::fail(Error::Code::InvalidArgument,
                              "the store folder holds something that is not of a store: " + name,
                              "give a new or empty folder");
    }
    if (error)
        return core::fail(Error::Code::Io, "cannot list the store folder: " + error.message());
    return {};
}

bool write_all(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const auto count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

} // namespace

core::Result<StoreWriter> StoreWriter::open(const fs::path& folder,
                                            const std::function<void()>& waiting) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder))
        return core::fail(Error::Code::Io, "cannot make the store folder: " + error.message());
    if (auto ours = check_contents(folder); !ours)
        return tl::unexpected(ours.error());
    const fs::path name = folder / lock_name;
    StoreWriter writer(folder, ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (writer.lock_ < 0)
        return failure("cannot write to the store folder");
    if (::flock(writer.lock_, LOCK_EX | LOCK_NB) == 0)
        return writer;
    waiting();
    while (::flock(writer.lock_, LOCK_EX) != 0)
        if (errno != EINTR)
            return failure("cannot lock the store folder");
    return writer;
}

StoreWriter::StoreWriter(StoreWriter&& other) noexcept
    : folder_(std::move(other.folder_)), lock_(std::exchange(other.lock_, -1)) {}

StoreWriter::~StoreWriter() {
    if (lock_ >= 0)
        ::close(lock_);
}

core::Result<void> StoreWriter::clear() {
    std::error_code error;
    fs::remove(folder_ / protocol::manifest_file_name, error);
    std::vector<fs::path> files;
    if (!error)
        for (const auto& entry : fs::directory_iterator(folder_, error))
            if (written_by_an_importer(entry.path().filename().string()))
                files.push_back(entry.path());
    for (const auto& file : files)
        if (!error)
            fs::remove(file, error);
    if (error)
        return core::fail(Error::Code::Io, "cannot empty the store folder: " + error.message());
    return {};
}

core::Result<void> StoreWriter::write(const std::string& name, std::span<const std::byte> bytes) {
    const fs::path whole = folder_ / name;
    const std::string part = whole.string() + ".part";
    if (part.size() >= part_name.size())
        return core::fail(Error::Code::InvalidArgument, "the path of the store is too long");
    std::memcpy(part_name.data(), part.c_str(), part.size() + 1);
    unfinished = true;
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    bool good = file >= 0 && write_all(file, bytes) && ::fdatasync(file) == 0;
    const int reason = errno;
    if (file >= 0 && ::close(file) != 0)
        good = false;
    if (good && ::rename(part.c_str(), whole.c_str()) == 0) {
        unfinished = false;
        return {};
    }
    errno = good ? errno : reason;
    auto error = failure("cannot write " + name);
    ::unlink(part.c_str());
    unfinished = false;
    return error;
}

void end_on_signals() {
    struct sigaction action {};

    action.sa_handler = end_now;
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    ::signal(SIGPIPE,
             SIG_IGN); // the program that reads the progress may go away; the import goes on
}

} // namespace wakesurf::server
