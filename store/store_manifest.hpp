// A store's manifest, store.json <-> values: what wakesurf-import and `wakesurf generate` write and
// the server opens a store by.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "protocol/api/base/json_members.hpp"
#include "store/store_layout.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

inline constexpr std::string_view manifest_file_name = "store.json";

/// Time-steps that are read as wholes are of the one version, those in bricks of the other. Stores of any
/// other version are refused: importing again is cheaper than reading all versions.
inline constexpr std::uint64_t store_format_version = 2;
inline constexpr std::uint64_t brick_format_version = 3;

struct SourceFile {
    std::string name; ///< as the series names it, without the folder of the series
    std::uint64_t size = 0;
    std::int64_t mtime = 0; ///< nanoseconds since 1970

    bool operator==(const SourceFile&) const = default;
};

/// The source of a store: equal sources give equal stores, so an import of one need not be repeated.
struct StoreSource {
    std::vector<SourceFile> files; ///< what all time-steps share
    /// Of each time-step; behind them those of one that cannot be read, before which the store ends.
    std::vector<std::vector<SourceFile>> steps;
    /// The --fields and --times of an import, where empty means everything; flow, grid and times of a
    /// generated store.
    std::string selection;

    bool operator==(const StoreSource&) const = default;
};

struct StoreManifest {
    bool complete = false; ///< false while it is written, and while the source may still grow
    StoreSource source;
    core::DatasetInfo info;
    StoreLayout layout;                        ///< its folder is empty: a store may be moved
    std::vector<std::size_t> without_velocity; ///< time-steps written with no finite velocity
    std::array<double, 2> velocity_range{0.0,
                                         0.0}; ///< of the speed, over the time-steps written so far
};

std::string store_manifest_text(const StoreManifest& manifest);

/// Parses the text of store.json. Error: Corrupt or OverLimit for text that is no manifest, Unsupported for
/// another version, and Corrupt where its parts disagree: times, dimensions, bounds and sizes must match each
/// other.
core::Result<StoreManifest> parse_store_manifest(std::string_view text);

/// Reads and parses `folder`/store.json. Error: NotFound, Io, and as parse_store_manifest.
core::Result<StoreManifest> read_store_manifest(const std::filesystem::path& folder,
                                                const core::Disk& disk);

/// Returns the layout in a folder.
StoreLayout store_layout(const StoreManifest& manifest, std::filesystem::path folder);

} // namespace wakesurf::store

namespace wakesurf::protocol {

/// The layout as members of store.json, without its folder, because a store may be moved. What would lead out
/// of the folder is refused.
template <class Io>
void members(Io& io, Of<Io, store::StoreLayout>& of);

} // namespace wakesurf::protocol
