// Writes a store: one importer at a time, every file whole or absent (written as *.part, then renamed).
#pragma once

#include "core/base/result.hpp"
#include "protocol/store_manifest.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace wakesurf::server {

class StoreWriter {
  public:
    /// Makes the folder and locks it; calls `waiting` once if another importer holds it, and waits.
    /// Error: InvalidArgument for a folder with other things in it, Io.
    static core::Result<StoreWriter> open(const std::filesystem::path& folder,
                                          const std::function<void()>& waiting);
    StoreWriter(StoreWriter&& other) noexcept;
    StoreWriter& operator=(StoreWriter&&) = delete;
    ~StoreWriter();

    /// Removes everything an importer wrote, the manifest first.
    core::Result<void> clear();

    /// Error: Io, a full disk for example; nothing is left of the file then.
    core::Result<void> write(const std::string& name, std::span<const std::byte> bytes);

    const std::filesystem::path& folder() const { return folder_; }

  private:
    StoreWriter(std::filesystem::path folder, int lock) : folder_(std::move(folder)), lock_(lock) {}

    std::filesystem::path folder_;
    int lock_;
};

/// On SIGINT and SIGTERM: removes the unfinished file, says so and ends the process with status 1 at once.
void end_on_signals();

} // namespace wakesurf::server
