#include "store/store_writer.hpp"

#include "core/base/crc32c.hpp"
#include "store/file_writing.hpp"
#include "store/stored_families.hpp"
#include "store/stored_means.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace wakesurf::store {

using core::Error;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view lock_name = "store.lock";

// Hold what a signal handler may touch: the name of the unfinished file, valid while `unfinished` is set.
std::array<char, 4096> part_name{};
std::atomic<bool> unfinished{false};
std::string_view last_words;
void (*before_end)() = nullptr;

// A file reaches the disk in portions, so that one as large as memory neither fills it with unwritten pages
// nor keeps Ctrl-C waiting for all of them at the end.
constexpr off_t portion_bytes = off_t{32} << 20;

extern "C" void end_now(int) {
    if (before_end != nullptr)
        before_end();
    if (unfinished.load())
        ::unlink(part_name.data());
    [[maybe_unused]] const auto written =
        ::write(STDERR_FILENO, last_words.data(), last_words.size());
    ::_exit(1);
}

tl::unexpected<Error> failure(const std::string& what) {
    const int error = errno;
    return core::fail(Error::Code::Io, what + ": " + std::generic_category().message(error));
}

bool of_a_time_step(const std::string& name) {
    const auto digits = name.rfind('_') + 1; // 0 where there is none
    const auto dot = name.find('.', digits);
    return digits > 1 && dot != std::string::npos && dot - digits >= 6 &&
           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(digits),
                       name.begin() + static_cast<std::ptrdiff_t>(dot),
                       [](char c) { return c >= '0' && c <= '9'; }) &&
           (name.substr(dot) == ".f32" || name.substr(dot) == ".f16" ||
            name.substr(dot) == bricks_suffix);
}

bool of_a_store(const std::string& name) {
    constexpr std::array<std::string_view, 14> fixed{manifest_file_name,
                                                     families_list.file,
                                                     means_list.file,
                                                     mask_file_name,
                                                     checksums_file_name,
                                                     "x.f64",
                                                     "y.f64",
                                                     "z.f64",
                                                     "points.f64",
                                                     "cells.u32",
                                                     "beyond.u32",
                                                     "shapes.u8",
                                                     "walls.f32",
                                                     "walls.u32"};
    return std::find(fixed.begin(), fixed.end(), name) != fixed.end() || of_a_time_step(name) ||
           name.ends_with(".part");
}

core::Result<void> check_contents(const fs::path& folder) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name != lock_name && !of_a_store(name))
            return core::fail(Error::Code::InvalidArgument,
                              "the store folder holds something that does not belong to a store: " +
                                  name,
                              "give a new or empty folder");
    }
    if (error)
        return core::fail(Error::Code::Io, "cannot list the store folder: " + error.message());
    return {};
}

core::Result<void> cannot_write(const std::string& name) {
    const bool full = errno == ENOSPC || errno == EDQUOT;
    auto error = failure("cannot write " + name);
    if (full)
        error.value().hint = "free some disk space, then run the same command again to resume";
    return error;
}

/// Checks that bytes fit beside what stays free for others.
core::Result<void> check_room(int file, const std::string& name, std::uint64_t bytes) {
    struct statvfs disk {};

    if (::fstatvfs(file, &disk) != 0 || disk.f_bavail * disk.f_frsize >= bytes + disk_reserve)
        return {};
    errno = ENOSPC;
    return cannot_write(name);
}

core::Result<std::uint32_t> fill(int file, const std::string& name, const NextPiece& next) {
    std::uint32_t sum = 0;
    for (off_t at = 0, portion = 0;;) {
        const auto piece = next();
        if (!piece)
            return tl::unexpected(piece.error());
        if (auto room = check_room(file, name, piece->size()); !room)
            return tl::unexpected(room.error());
        if (!write_whole(file, *piece))
            return tl::unexpected(cannot_write(name).error());
        sum = core::crc32c(*piece, sum);
        at += static_cast<off_t>(piece->size());
        if (piece->empty()) { // the remaining work is automatic; settle() waits for it
            ::sync_file_range(file, portion, 0, SYNC_FILE_RANGE_WRITE);
            return sum;
        }
        if (at - portion < portion_bytes)
            continue;
        // Starts this portion on its way to the disk and waits for the one before, as the disk works at its
        // own pace.
        ::sync_file_range(file, portion, at - portion, SYNC_FILE_RANGE_WRITE);
        ::sync_file_range(file, 0, portion, SYNC_FILE_RANGE_WAIT_BEFORE);
        portion = at;
    }
}

/// Runs `write` on the file *.part, which becomes the file `name` if that goes well, and is removed if it
/// does not.
template <class Write>
auto appear(const fs::path& folder, const std::string& name, const Write& write)
    -> decltype(write(0)) {
    const fs::path whole = folder / name;
    const std::string part = whole.string() + ".part";
    if (part.size() >= part_name.size())
        return core::fail(Error::Code::InvalidArgument, "the path of the store is too long");
    std::memcpy(part_name.data(), part.c_str(), part.size() + 1);
    unfinished = true;
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const auto failed = [&] { return tl::unexpected(cannot_write(name).error()); };
    decltype(write(0)) written = failed();
    if (file >= 0)
        written = write(file);
    if (file >= 0 && ::close(file) != 0 && written)
        written = failed();
    if (written && ::rename(part.c_str(), whole.c_str()) != 0)
        written = failed();
    if (!written)
        ::unlink(part.c_str());
    unfinished = false;
    return written;
}

} // namespace

core::Result<StoreWriter> StoreWriter::open(const fs::path& folder,
                                            const std::function<core::Result<void>()>& waiting) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder))
        return core::fail(Error::Code::Io, "cannot create the store folder: " + error.message());
    if (auto ours = check_contents(folder); !ours)
        return tl::unexpected(ours.error());
    const fs::path name = folder / lock_name;
    StoreWriter writer(folder, ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (writer.lock_ < 0)
        return failure("cannot write to the store folder");
    if (::flock(writer.lock_, LOCK_EX | LOCK_NB) == 0)
        return writer;
    if (auto patient = waiting(); !patient)
        return tl::unexpected(patient.error());
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
    fs::remove(folder_ / manifest_file_name, error);
    std::vector<fs::path> files;
    if (!error)
        for (const auto& entry : fs::directory_iterator(folder_, error))
            if (of_a_store(entry.path().filename().string()))
                files.push_back(entry.path());
    for (const auto& file : files)
        if (!error)
            fs::remove(file, error);
    if (error)
        return core::fail(Error::Code::Io, "cannot empty the store folder: " + error.message());
    return {};
}

core::Result<std::uint32_t> StoreWriter::write(const std::string& name,
                                               std::span<const std::byte> bytes) {
    return write(name, [rest = bytes]() mutable {
        return core::Result<std::span<const std::byte>>(std::exchange(rest, {}));
    });
}

core::Result<std::uint32_t> StoreWriter::write(const std::string& name, const NextPiece& next) {
    return appear(folder_, name, [&](int file) { return fill(file, name, next); });
}

core::Result<void>
StoreWriter::write_in_place(const std::string& name,
                            std::uint64_t size,
                            const std::function<core::Result<void>(const PutBytes&)>& fill) {
    return appear(folder_, name,
                  [&](int file) -> core::Result<int> {
                      if (auto room = check_room(file, name, size); !room)
                          return tl::unexpected(room.error());
                      // Allocates contiguous space for pieces, if the file system can; a full disk is
                      // reported now.
                      if (::fallocate(file, 0, 0, static_cast<off_t>(size)) != 0 &&
                          (errno == ENOSPC || errno == EDQUOT))
                          return tl::unexpected(cannot_write(name).error());
                      off_t unsent = 0;
                      return fill([&](std::uint64_t at,
                                      std::span<const std::byte> bytes) -> core::Result<void> {
                                 if (!write_whole_at(file, at, bytes))
                                     return cannot_write(name);
                                 unsent += static_cast<off_t>(bytes.size());
                                 if (unsent < portion_bytes)
                                     return {};
                                 // This does what fill() above does, for a file whose bytes come in no order:
                                 // 0 is all of it.
                                 ::sync_file_range(file, 0, 0,
                                                   SYNC_FILE_RANGE_WAIT_BEFORE |
                                                       SYNC_FILE_RANGE_WRITE);
                                 unsent = 0;
                                 return {};
                             })
                          .map([] { return 0; });
                  })
        .map([](int) {});
}

core::Result<void> StoreWriter::repeat(const std::string& name, const std::string& again) {
    std::error_code none;
    fs::remove(folder_ / again, none);
    if (::link((folder_ / name).c_str(), (folder_ / again).c_str()) == 0)
        return {};
    std::ifstream in(folder_ / name, std::ios::binary);
    std::vector<char> piece(std::size_t{1} << 20);
    return write(again,
                 [&]() -> core::Result<std::span<const std::byte>> {
                     in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
                     if (in.bad() || !in.is_open())
                         return tl::unexpected(failure("cannot read " + name).value());
                     return std::as_bytes(
                         std::span(piece).first(static_cast<std::size_t>(in.gcount())));
                 })
        .map([](std::uint32_t) {});
}

core::Result<void> StoreWriter::finish_step(std::size_t index,
                                            std::span<const std::uint32_t> checksums) {
    const std::string name(checksums_file_name);
    const auto bytes = std::as_bytes(checksums);
    const int file = ::open((folder_ / name).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0)
        return cannot_write(name);
    const auto at = static_cast<off_t>(index * bytes.size());
    if (::lseek(file, 0, SEEK_END) < at) { // a hole would make the time-steps before it ready
        ::close(file);
        throw std::logic_error("a time-step was finished before the one before it");
    }
    const bool written = ::lseek(file, at, SEEK_SET) == at && write_whole(file, bytes);
    auto outcome = written ? core::Result<void>() : cannot_write(name);
    ::close(file); // what is left of a record cut off counts as none
    return outcome;
}

core::Result<void> StoreWriter::settle() {
    return ::syncfs(lock_) == 0 ? core::Result<void>() : cannot_write("the store");
}

std::optional<std::vector<std::uint32_t>> StoreWriter::finished_step(std::size_t index,
                                                                     std::size_t columns) const {
    std::vector<std::uint32_t> checksums(columns);
    const auto bytes = std::as_writable_bytes(std::span(checksums));
    const core::PosixDisk disk;
    if (!disk.read(folder_ / checksums_file_name, index * bytes.size(), bytes))
        return std::nullopt;
    return checksums;
}

void end_on_signals(std::string_view words, void (*first)()) {
    last_words = words;
    before_end = first;

    struct sigaction action {};

    action.sa_handler = end_now;
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    ::signal(SIGPIPE,
             SIG_IGN); // the reader of the progress may close; the import continues
}

} // namespace wakesurf::store
