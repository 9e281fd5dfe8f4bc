// Small files beside a store's data that list what was made of them and is kept there: families.json and
// means.json. They are files of their own, since store.json is its importer's, which may be writing it.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

/// What a list is called.
struct KeptList {
    std::string_view file; ///< families.json
    std::string_view what; ///< families
    std::string_view
        stem; ///< of the files of its entries, before a number: family_. No stem of a scalar has a `_`
};

inline constexpr std::uint64_t kept_list_version = 1;

/// Returns the entries; none where the file is not there. Error: Io, Corrupt.
core::Result<std::vector<nlohmann::json>>
read_kept(const KeptList& list, const std::filesystem::path& folder, const core::Disk& disk);

/// Error that the file is damaged.
core::Error damaged(const KeptList& list, const core::Error& error);

/// Returns the bytes of the file.
std::string kept_text(const KeptList& list, const nlohmann::json& entries);

/// Says whether a stem may become part of a file name.
bool is_stem(const KeptList& list, std::string_view stem);

/// Returns the first stem that no file of the folder has, listed or not.
std::string unused_stem(const KeptList& list, const std::filesystem::path& folder);

/// Stays free on the disk of a store: what is kept is for everybody, and sessions may be on the same disk.
inline constexpr std::uint64_t disk_reserve = std::uint64_t{64} << 20;

/// Checks that values can be written. Error: Io where the folder cannot be written to, or its disk has less
/// room than `bytes` and the reserve.
core::Result<void>
check_room_for(const std::filesystem::path& folder, std::uint64_t bytes, std::string_view what);

} // namespace wakesurf::store
