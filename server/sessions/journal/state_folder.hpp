// The folder of `--state`: used by one server at a time, readable by its user only.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// Makes an empty file (0600). Error: Io, also if the name exists.
core::Result<void> make_private_file(const std::string& path);

/// Locks the folder until destroyed, and until the process ends at the latest.
class StateFolder {
  public:
    /// Locks the folder; makes it (0700) and an empty database file (0600) if missing. Error: Io; OverLimit
    /// if another server uses the folder.
    static core::Result<StateFolder> hold(const std::filesystem::path& folder);

    /// Locks an existing folder, and makes nothing. Error: NotFound without a folder; Io; OverLimit.
    static core::Result<StateFolder> hold_existing(const std::filesystem::path& folder);

    ~StateFolder();
    StateFolder(StateFolder&& other) noexcept;
    StateFolder& operator=(StateFolder&& other) noexcept;

    const std::filesystem::path& path() const { return folder_; }

    /// Returns the path of the database.
    std::string file() const { return (folder_ / "sessions.sqlite").string(); }

  private:
    static core::Result<StateFolder> lock(const std::filesystem::path& folder);

    StateFolder(std::filesystem::path folder, int descriptor)
        : folder_(std::move(folder)), descriptor_(descriptor) {}

    std::filesystem::path folder_;
    int descriptor_;
};

} // namespace wakesurf::server
