// The folder of `--state`: one server at a time, and no one else's business.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// An empty file (0600) where there is none of this name. Error: Io, also where there is one.
core::Result<void> make_private_file(const std::string& path);

/// Held until it is destroyed, and until the process ends at the latest.
class StateFolder {
  public:
    /// Makes the folder (0700) and an empty database file (0600) where there is none. Error: Io; OverLimit
    /// where another server holds the folder.
    static core::Result<StateFolder> hold(const std::filesystem::path& folder);

    /// Does the same, making nothing. Error: NotFound where there is no folder; Io; OverLimit.
    static core::Result<StateFolder> hold_existing(const std::filesystem::path& folder);

    ~StateFolder();
    StateFolder(StateFolder&& other) noexcept;
    StateFolder& operator=(StateFolder&& other) noexcept;

    const std::filesystem::path& path() const { return folder_; }

    /// Path of the database.
    std::string file() const { return (folder_ / "sessions.sqlite").string(); }

  private:
    static core::Result<StateFolder> lock(const std::filesystem::path& folder);

    StateFolder(std::filesystem::path folder, int descriptor)
        : folder_(std::move(folder)), descriptor_(descriptor) {}

    std::filesystem::path folder_;
    int descriptor_;
};

} // namespace wakesurf::server
