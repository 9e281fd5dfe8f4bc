// Writes a store: one writer at a time, every file whole or absent (written as *.part, then renamed).
#pragma once

#include "core/base/result.hpp"
#include "store/store_manifest.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

/// The next bytes of a file, valid until the next call; none at its end. After an error the file is
/// abandoned.
using NextPiece = std::function<core::Result<std::span<const std::byte>>()>;

/// Puts bytes at their place in a file. Error: Io.
using PutBytes =
    std::function<core::Result<void>(std::uint64_t at, std::span<const std::byte> bytes)>;

class StoreWriter {
  public:
    /// Makes the folder and locks it; calls `waiting` once if another writer holds it, and waits, or gives up
    /// with the error it returns. Error: InvalidArgument for a folder with other things in it, Io.
    static core::Result<StoreWriter> open(const std::filesystem::path& folder,
                                          const std::function<core::Result<void>()>& waiting);
    StoreWriter(StoreWriter&& other) noexcept;
    StoreWriter& operator=(StoreWriter&&) = delete;
    ~StoreWriter();

    /// Removes everything a writer wrote, the manifest first.
    core::Result<void> clear();

    /// Returns the file's CRC-32C. Error: Io, a full disk for example; nothing is left of the file then.
    core::Result<std::uint32_t> write(const std::string& name, std::span<const std::byte> bytes);

    /// Writes a file that need not be in memory as a whole. Error: Io, or what `next` reports.
    core::Result<std::uint32_t> write(const std::string& name, const NextPiece& next);

    /// Writes a file whose bytes come in another order: `fill` puts all of them. Error: Io, or what `fill`
    /// reports.
    core::Result<void>
    write_in_place(const std::string& name,
                   std::uint64_t size,
                   const std::function<core::Result<void>(const PutBytes&)>& fill);

    /// Gives a file that is written a second name; copies it where the file system has no links. Error: Io.
    core::Result<void> repeat(const std::string& name, const std::string& again);

    /// Makes time-step `index` ready, all files of which are written: readers see that by its checksums, one
    /// a stored field. REQUIRES: the time-steps before it are ready. Error: Io.
    core::Result<void> finish_step(std::size_t index, std::span<const std::uint32_t> checksums);

    /// Waits until everything written is on the disk, where a power failure leaves it whole. To be called
    /// before a manifest says that the store is complete; what is left of one that is not, checksums tell.
    /// Error: Io.
    core::Result<void> settle();

    /// The checksums of time-step `index`, if it is ready. @param columns  stored fields
    std::optional<std::vector<std::uint32_t>> finished_step(std::size_t index,
                                                            std::size_t columns) const;

    const std::filesystem::path& folder() const { return folder_; }

  private:
    StoreWriter(std::filesystem::path folder, int lock) : folder_(std::move(folder)), lock_(lock) {}

    std::filesystem::path folder_;
    int lock_;
};

/// Handles SIGINT and SIGTERM: removes the unfinished file, writes `words` (which live as long as the
/// process) to standard error and ends the process with status 1 at once. `first` is called before that; it
/// may do what a signal handler may.
void end_on_signals(std::string_view words, void (*first)() = nullptr);

} // namespace wakesurf::store
