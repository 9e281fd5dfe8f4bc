#include "store/stored_families.hpp"

#include "core/base/crc32c.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"
#include "store/file_writing.hpp"
#include "store/store_layout.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace wakesurf::store {

using core::Error;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view families_format = "wakesurf-families";
constexpr std::uint64_t families_version = 1;
constexpr protocol::JsonLimits families_limits{std::size_t{4} << 20, 16};
constexpr std::string_view stem_begin = "family_"; // no stem of a scalar has a `_`

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
    return protocol::json_text(
        {{"format", families_format}, {"version", families_version}, {"families", std::move(all)}},
        1);
}

// Returns whether it may become part of a file name.
bool family_stem(const std::string& stem) {
    const std::string_view number =
        std::string_view(stem).substr(std::min(stem.size(), stem_begin.size()));
    return stem.starts_with(stem_begin) && !number.empty() && number.size() <= 9 &&
           std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
}

core::Result<StoredFamily> parse_one(const json& value) {
    protocol::JsonReader in(value);
    StoredFamily family;
    members(in, family.record);
    in.needed("stem", family.stem);
    if (!family_stem(family.stem))
        in.check("stem", "is no beginning of a file name");
    std::vector<std::array<std::uint32_t, 2>> sums;
    in.needed("checksums", sums);
    for (const auto& [velocity, values] : sums)
        family.sums.push_back({velocity, values});
    if (family.sums.size() != family.record.steps.size())
        in.check("checksums", "must be two numbers a step");
    return in.verdict().map([&] { return std::move(family); });
}

core::Result<std::vector<StoredFamily>> parse_families(const json& value) {
    protocol::JsonReader in(value);
    std::string format;
    std::uint64_t version = 0;
    std::vector<json> list;
    in.needed("format", format);
    in.needed("version", version);
    in.needed("families", list);
    if (format != families_format)
        in.check("format", "is not that of a wakesurf store's families");
    if (version != families_version)
        in.check("version", "is one that this wakesurf does not read");
    std::vector<StoredFamily> families;
    for (const json& each : list) {
        auto family = parse_one(each);
        if (!family)
            return tl::unexpected(family.error());
        families.push_back(std::move(*family));
    }
    return in.verdict().map([&] { return std::move(families); });
}

/// Returns the first number that no file of the folder has, listed or not.
std::string unused_stem(const fs::path& folder) {
    std::set<std::string> used;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (const std::string name = entry.path().filename().string(); name.starts_with(stem_begin))
            used.insert(name.substr(0, name.rfind('_')));
    for (int number = 1;; ++number)
        if (std::string stem = std::string(stem_begin) + std::to_string(number);
            !used.contains(stem))
            return stem;
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
    const auto file = folder / families_file_name;
    const auto size = disk.size(file);
    if (!size && size.error().code == Error::Code::NotFound)
        return std::vector<StoredFamily>();
    if (!size)
        return tl::unexpected(size.error());
    const auto damaged = [](const Error& error) {
        return Error{Error::Code::Corrupt, std::string(families_file_name) + ": " + error.message,
                     "delete that file from the store, and make the families again"};
    };
    if (*size > families_limits.bytes)
        return tl::unexpected(damaged({Error::Code::Corrupt, "it is too long", ""}));
    std::string text(static_cast<std::size_t>(*size), '\0');
    if (auto read = disk.read(file, 0, std::as_writable_bytes(std::span(text))); !read)
        return tl::unexpected(read.error());
    return protocol::parse_json(text, families_limits)
        .and_then([](const json& value) { return parse_families(value); })
        .map_error(damaged);
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

core::Result<void> check_room_for_family(const fs::path& folder, std::uint64_t bytes) {
    if (auto writable = FolderChanges::begin(folder); !writable)
        return tl::unexpected(writable.error());
    std::error_code error;
    const auto space = fs::space(folder, error);
    if (!error && space.available < bytes + disk_reserve)
        return core::fail(Error::Code::Io,
                          "the disk of the store has less room than the family's values take, " +
                              std::to_string(bytes >> 20) + " MiB, and the " +
                              std::to_string(disk_reserve >> 20) + " MiB that stay free",
                          "free some disk space, or remove a family");
    return {};
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
    StoredFamily family{std::move(record), unused_stem(folder), {}};
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
        written = changes->write(std::string(families_file_name), std::as_bytes(std::span(text)));
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
            changes->write(std::string(families_file_name), std::as_bytes(std::span(text)));
        !written)
        return written;
    remove_files(*changes, gone); // no longer listed
    return {};
}

} // namespace wakesurf::store
