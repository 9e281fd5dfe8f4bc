#include "store/kept_list.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "store/file_writing.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <span>
#include <system_error>

namespace wakesurf::store {

using core::Error;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr protocol::JsonLimits list_limits{std::size_t{4} << 20, 16};

std::string format_of(const KeptList& list) {
    return fmt::format("wakesurf-{}", list.what);
}

core::Result<std::vector<json>> entries_of(const KeptList& list, const json& value) {
    protocol::JsonReader in(value);
    std::string format;
    std::uint64_t version = 0;
    std::vector<json> entries;
    in.needed("format", format);
    in.needed("version", version);
    in.needed(list.what.data(), entries);
    if (format != format_of(list))
        in.check("format", "is not that of what is kept in a wakesurf store");
    if (version != kept_list_version)
        in.check("version", "is one that this wakesurf does not read");
    return in.verdict().map([&] { return std::move(entries); });
}

} // namespace

Error damaged(const KeptList& list, const Error& error) {
    return {Error::Code::Corrupt, fmt::format("{}: {}", list.file, error.message),
            fmt::format("delete that file from the store, and make the {} again", list.what)};
}

core::Result<std::vector<json>>
read_kept(const KeptList& list, const fs::path& folder, const core::Disk& disk) {
    const auto file = folder / list.file;
    const auto size = disk.size(file);
    if (!size && size.error().code == Error::Code::NotFound)
        return std::vector<json>();
    if (!size)
        return tl::unexpected(size.error());
    if (*size > list_limits.bytes)
        return tl::unexpected(damaged(list, {Error::Code::Corrupt, "it is too long", ""}));
    std::string text(static_cast<std::size_t>(*size), '\0');
    if (auto read = disk.read(file, 0, std::as_writable_bytes(std::span(text))); !read)
        return tl::unexpected(read.error());
    return protocol::parse_json(text, list_limits)
        .and_then([&](const json& value) { return entries_of(list, value); })
        .map_error([&](const Error& error) { return damaged(list, error); });
}

std::string kept_text(const KeptList& list, const json& entries) {
    return protocol::json_text({{"format", format_of(list)},
                                {"version", kept_list_version},
                                {std::string(list.what), entries}},
                               1);
}

bool is_stem(const KeptList& list, std::string_view stem) {
    const std::string_view number = stem.substr(std::min(stem.size(), list.stem.size()));
    return stem.starts_with(list.stem) && !number.empty() && number.size() <= 9 &&
           std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
}

std::string unused_stem(const KeptList& list, const fs::path& folder) {
    std::set<std::string> used;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (const std::string name = entry.path().filename().string(); name.starts_with(list.stem))
            used.insert(name.substr(0, name.find('_', list.stem.size())));
    for (int number = 1;; ++number)
        if (std::string stem = fmt::format("{}{}", list.stem, number); !used.contains(stem))
            return stem;
}

core::Result<void>
check_room_for(const fs::path& folder, std::uint64_t bytes, std::string_view what) {
    if (auto writable = check_writable(folder); !writable)
        return writable;
    std::error_code error;
    const auto space = fs::space(folder, error);
    if (!error && space.available < bytes + disk_reserve)
        return core::fail(Error::Code::Io,
                          fmt::format("the disk of the store has less room than the values of the "
                                      "{} take, {} MiB, and the {} MiB that stay free",
                                      what, bytes >> 20, disk_reserve >> 20),
                          fmt::format("free some disk space, or remove {}", what));
    return {};
}

} // namespace wakesurf::store
