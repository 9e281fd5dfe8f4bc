// families.json: which families of stream surfaces are kept beside a store's data, and in which files their
// values are.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"
#include "core/surface/family/family_record.hpp"
#include "store/kept_list.hpp"
#include "store/value_marks.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

inline constexpr KeptList families_list{"families.json", "families", "family_"};

/// A dataset has at most so many: each takes as much of the disk as a scalar field.
inline constexpr std::size_t most_families = 16;

struct StoredFamily {
    struct Sums {
        std::uint32_t velocity = 0; ///< CRC-32C of what its nodes were traced through
        std::uint32_t values = 0;   ///< CRC-32C of its own file

        bool operator==(const Sums&) const = default;
    };

    core::FamilyRecord record;
    std::string stem;       ///< of its files, which have 32 bits a value: <stem>_000000.f32
    std::vector<Sums> sums; ///< one a step of the record

    bool operator==(const StoredFamily&) const = default;
};

/// All that are in the folder; none where the file is not there. Error: Io, Corrupt.
core::Result<std::vector<StoredFamily>> read_families(const std::filesystem::path& folder,
                                                      const core::Disk& disk);

/// Returns those families, and those of their steps, that were traced through the present velocities.
std::vector<StoredFamily> current_families(std::vector<StoredFamily> families,
                                           const ValueMarks& now);

/// Writes the values, then families.json with this one more: a reader sees it whole or not at all, and so
/// does the next start after a power cut. One process at a time. Its stem and sums are chosen here. Those
/// whose velocities are gone go with it.
/// @param now     of the velocities it was traced through
/// @param values  of each step
/// @param taken   whether it may be added to those that are there: asked while no other can be added Error:
///                what `taken` returns; OverLimit beyond most_families; Io, with nothing changed.
core::Result<void>
add_family(const std::filesystem::path& folder,
           const ValueMarks& now,
           core::FamilyRecord record,
           std::span<const std::vector<float>> values,
           const std::function<core::Result<void>(const std::vector<StoredFamily>&)>& taken);

/// Removes a family. Error: NotFound, Io, Corrupt.
core::Result<void> remove_family(const std::filesystem::path& folder, std::string_view name);

} // namespace wakesurf::store
