#include "store/stored_families.hpp"

#include "core/base/crc32c.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/dataset_json.hpp"
#include "store/file_writing.hpp"
#include "store/store_layout.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace wakesurf::store {

using core::Error;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string families_text(const std::vector<StoredFamily>& families) {
    json all = json::array();
    for (const StoredFamily& each : families) {
        json one = protocol::written(each.record);
        one["stem"] = each.stem;
        one["checksums"] = json::array();
        for (const StoredFamily::Sums& sums : each.sums)
            one["checksums"].push_back({sums.velocity, sums.values});
        all.push_back(std::move(one));
    }
    return kept_text(families_list, all);
}

core::Result<StoredFamily> parse_one(const json& value) {
    protocol::JsonReader in(value);
    StoredFamily family;
    members(in, family.record);
    in.needed("stem", family.stem);
    if (!is_stem(families_list, family.stem))
        in.check("stem", "is no beginning of a file name");
    std::vector<std::array<std::uint32_t, 2>> sums;
    in.needed("checksums", sums);
    for (const auto& [velocity, values] : sums)
        family.sums.push_back({velocity, values});
    if (family.sums.size() != family.record.steps.size())
        in.check("checksums", "must be two numbers a step");
    return in.verdict().map([&] { return std::move(family); });
}

std::string file_of(const StoredFamily& family, std::size_t step) {
    return step_file_name(family.stem, family.record.steps[step].index, core::Precision::Single);
}

void remove_files(const FolderChanges& changes, const StoredFamily& family) {
    for (std::size_t step = 0; step < family.record.steps.size(); ++step)
        changes.remove(file_of(family, step));
}

} // namespace

core::Result<std::vector<StoredFamily>> read_families(const fs::path& folder,
                                                      const core::Disk& disk) {
    const auto entries = read_kept(families_list, folder, disk);
    if (!entries)
        return tl::unexpected(entries.error());
    std::vector<StoredFamily> families;
    for (const json& each : *entries) {
        auto family = parse_one(each);
        if (!family)
            return tl::unexpected(damaged(families_list, family.error()));
        families.push_back(std::move(*family));
    }
    return families;
}

std::vector<StoredFamily> current_families(std::vector<StoredFamily> families,
                                           const ValueMarks& now) {
    for (StoredFamily& family : families) {
        StoredFamily kept{family.record, family.stem, {}};
        kept.record.steps.clear();
        for (std::size_t i = 0; i < family.record.steps.size(); ++i) {
            const std::size_t index = family.record.steps[i].index;
            if (index >= now.steps() || now.checksum(index, 0) != family.sums[i].velocity)
                continue;
            kept.record.steps.push_back(family.record.steps[i]);
            kept.sums.push_back(family.sums[i]);
        }
        family = std::move(kept);
    }
    std::erase_if(families, [](const StoredFamily& each) { return each.record.steps.empty(); });
    return families;
}

core::Result<void>
add_family(const fs::path& folder,
           const ValueMarks& now,
           core::FamilyRecord record,
           std::span<const std::vector<float>> values,
           const std::function<core::Result<void>(const std::vector<StoredFamily>&)>& taken) {
    const auto changes = FolderChanges::begin(folder);
    if (!changes)
        return tl::unexpected(changes.error());
    const auto before = read_families(folder, core::PosixDisk());
    if (!before)
        return tl::unexpected(before.error());
    auto all = current_families(*before, now);
    if (auto free = taken(all); !free)
        return free;
    if (all.size() >= most_families)
        return core::over_limit(
            most_families, "the dataset has " + std::to_string(most_families) + " families already",
            "remove one");
    StoredFamily family{std::move(record), unused_stem(families_list, folder), {}};
    core::Result<void> written;
    for (std::size_t step = 0; step < values.size() && written; ++step) {
        const auto bytes = std::as_bytes(std::span(values[step]));
        family.sums.push_back(
            {now.checksum(family.record.steps[step].index, 0), core::crc32c(bytes)});
        written = changes->write(file_of(family, step), bytes);
    }
    all.push_back(family);
    if (written) {
        const std::string text = families_text(all);
        written = changes->write(std::string(families_list.file), std::as_bytes(std::span(text)));
    }
    if (!written) {
        remove_files(*changes, family);
        return written;
    }
    for (const StoredFamily& each : *before)
        if (std::ranges::find(all, each.stem, &StoredFamily::stem) == all.end())
            remove_files(*changes, each);
    return {};
}

core::Result<void> remove_family(const fs::path& folder, std::string_view name) {
    const auto changes = FolderChanges::begin(folder);
    if (!changes)
        return tl::unexpected(changes.error());
    auto all = read_families(folder, core::PosixDisk());
    if (!all)
        return tl::unexpected(all.error());
    const auto found = std::ranges::find_if(
        *all, [&](const StoredFamily& each) { return each.record.name == name; });
    if (found == all->end())
        return core::fail(Error::Code::NotFound, "there is no family " + std::string(name),
                          "`dataset.describe` lists those there are");
    const StoredFamily gone = *found;
    all->erase(found);
    const std::string text = families_text(*all);
    if (auto written =
            changes->write(std::string(families_list.file), std::as_bytes(std::span(text)));
        !written)
        return written;
    remove_files(*changes, gone); // no longer listed
    return {};
}

} // namespace wakesurf::store
