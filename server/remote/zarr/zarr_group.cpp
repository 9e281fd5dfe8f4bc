#include "server/remote/zarr/zarr_group.hpp"

#include "core/base/crc32c.hpp"
#include "server/remote/web/web_address.hpp"
#include "server/remote/zarr/zarr_metadata.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t longest_metadata = std::uint64_t{64} << 20;
constexpr std::size_t most_arrays = 4096;

/// The usual names of arrays of a velocity and its coordinates, tried if names cannot be listed.
constexpr std::array usual_names{
    "u",          "v",          "w",  "U",  "V",  "W",    "ux",       "uy",  "uz",
    "Ux",         "Uy",         "Uz", "vx", "vy", "vz",   "velocity", "vel", "velocity_x",
    "velocity_y", "velocity_z", "x",  "y",  "z",  "time", "t"};

bool is_missing(const Error& error) {
    return error.code == Error::Code::NotFound;
}

class Reading {
  public:
    Reading(fs::path root, const core::Disk& disk) : root_(std::move(root)), disk_(disk) {}

    Result<ZarrGroup> run(const std::optional<std::vector<std::string>>& names) {
        for (const auto& read : {&Reading::read_3, &Reading::read_2})
            if (const auto found = (this->*read)(names); found)
                break;
            else if (!is_missing(found.error()))
                return tl::unexpected(found.error());
        if (!found_)
            return fail(Error::Code::NotFound,
                        root_.filename().string() +
                            " holds no Zarr: there is "
                            "neither zarr.json nor .zmetadata, .zgroup or .zarray");
        std::ranges::sort(group_.arrays, {}, &ZarrArray::name);
        return std::move(group_);
    }

  private:
    /// Reads the metadata. Error: NotFound if there are none.
    Result<json> metadata(const fs::path& below) {
        const auto named = [&](Error error) {
            error.message = below.string() + ": " + error.message;
            return error;
        };
        const auto size = disk_.size(root_ / below);
        if (!size)
            return tl::unexpected(size.error());
        if (*size > longest_metadata)
            return fail(Error::Code::OverLimit, below.string() + " is too long");
        std::string text(static_cast<std::size_t>(*size), '\0');
        const auto bytes = std::as_writable_bytes(std::span(text));
        if (auto got = disk_.read(root_ / below, 0, bytes); !got)
            return tl::unexpected(got.error());
        group_.mark = core::crc32c(bytes, group_.mark);
        auto value = parse_zarr_json(text).map_error(named);
        if (value && !value->is_object())
            return fail(Error::Code::Corrupt, below.string() + ": it must be an object");
        return value;
    }

    Result<void> add(const std::string& name, Result<ZarrArray> array) {
        if (group_.arrays.size() + group_.refused.size() >= most_arrays)
            return fail(Error::Code::OverLimit,
                        "the Zarr has more than " + std::to_string(most_arrays) + " arrays");
        if (array)
            group_.arrays.push_back(std::move(*array));
        else if (name.empty())
            return tl::unexpected(array.error());
        else
            group_.refused.emplace(name, array.error());
        return {};
    }

    Result<void> read_3(const std::optional<std::vector<std::string>>& names) {
        const auto root = metadata("zarr.json");
        if (!root)
            return tl::unexpected(root.error());
        found_ = true;
        group_.version = 3;
        if (root->value("node_type", json()) == "array")
            return add("", parse_zarr_3("", *root));
        const auto inside = root->find("consolidated_metadata");
        if (inside == root->end() || !inside->is_object() || !inside->contains("metadata"))
            return read_each(names, [&](const std::string& name) -> Result<ZarrArray> {
                const auto array = metadata(fs::path(name) / "zarr.json");
                if (!array)
                    return tl::unexpected(array.error());
                if (array->value("node_type", json()) != "array")
                    return fail(Error::Code::NotFound, "it is a group");
                return parse_zarr_3(name, *array);
            });
        for (const auto& [name, array] : (*inside)["metadata"].items())
            if (is_plain_name(name) && array.is_object() &&
                array.value("node_type", json()) == "array")
                if (auto added = add(name, parse_zarr_3(name, array)); !added)
                    return added;
        return {};
    }

    Result<void> read_2(const std::optional<std::vector<std::string>>& names) {
        if (const auto all = metadata(".zmetadata"))
            return read_consolidated_2(*all);
        else if (!is_missing(all.error()))
            return tl::unexpected(all.error());
        if (const auto root = metadata(".zarray")) {
            found_ = true;
            return add("", array_2("", *root));
        } else if (!is_missing(root.error())) {
            return tl::unexpected(root.error());
        }
        if (const auto group = metadata(".zgroup"); !group)
            return tl::unexpected(group.error());
        found_ = true;
        return read_each(names, [&](const std::string& name) -> Result<ZarrArray> {
            const auto array = metadata(fs::path(name) / ".zarray");
            if (!array)
                return tl::unexpected(array.error());
            return array_2(name, *array);
        });
    }

    Result<ZarrArray> array_2(const std::string& name, const json& array) {
        const auto attributes = metadata(fs::path(name) / ".zattrs");
        if (!attributes && !is_missing(attributes.error()))
            return tl::unexpected(attributes.error());
        return parse_zarr_2(name, array, attributes ? *attributes : json::object());
    }

    Result<void> read_consolidated_2(const json& all) {
        found_ = true;
        const auto inside = all.find("metadata");
        if (inside == all.end() || !inside->is_object())
            return fail(Error::Code::Corrupt, ".zmetadata: metadata is missing");
        constexpr std::string_view ending = "/.zarray";
        for (const auto& [path, array] : inside->items()) {
            const std::string name =
                path == ".zarray"
                    ? ""
                    : path.substr(0, path.size() - std::min(path.size(), ending.size()));
            if (path != name + std::string(ending) && path != ".zarray")
                continue;
            if (!name.empty() && !is_plain_name(name)) // in a group below, or outside
                continue;
            const auto attributes = inside->find(name.empty() ? ".zattrs" : name + "/.zattrs");
            if (auto added = add(
                    name, parse_zarr_2(name, array,
                                       attributes == inside->end() ? json::object() : *attributes));
                !added)
                return added;
        }
        return {};
    }

    template <class Read>
    Result<void> read_each(const std::optional<std::vector<std::string>>& names, const Read& read) {
        group_.listed = names.has_value();
        const auto add_named = [&](const std::string& name) -> Result<void> {
            if (group_.find(name) != nullptr || group_.refused.contains(name))
                return {};
            auto array = read(name);
            if (!array && is_missing(array.error()))
                return {};
            if (!array && array.error().code == Error::Code::Io)
                return tl::unexpected(array.error());
            return add(name, std::move(array));
        };
        std::vector<std::string> all =
            names.value_or(std::vector<std::string>(usual_names.begin(), usual_names.end()));
        for (const std::string& name : all)
            if (is_plain_name(name))
                if (auto added = add_named(name); !added)
                    return added;
        std::vector<std::string> coordinates;
        for (const ZarrArray& array : group_.arrays)
            coordinates.insert(coordinates.end(), array.dimensions.begin(), array.dimensions.end());
        for (const std::string& name : coordinates)
            if (auto added = names ? Result<void>() : add_named(name); !added)
                return added;
        return {};
    }

    fs::path root_;
    const core::Disk& disk_;
    ZarrGroup group_;
    bool found_ = false;
};

} // namespace

const ZarrArray* ZarrGroup::find(const std::string& name) const {
    const auto found = std::ranges::find(arrays, name, &ZarrArray::name);
    return found == arrays.end() ? nullptr : &*found;
}

Result<ZarrGroup> read_zarr_group(const fs::path& root,
                                  const core::Disk& disk,
                                  const std::optional<std::vector<std::string>>& names) {
    return Reading(root, disk).run(names);
}

} // namespace wakesurf::server
