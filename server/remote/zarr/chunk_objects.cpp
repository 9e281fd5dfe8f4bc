#include "server/remote/zarr/chunk_objects.hpp"

#include "server/remote/zarr/zarr_chunk.hpp"

#include <algorithm>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

constexpr std::uint64_t most_objects_a_line = 4096;

tl::unexpected<Error> changed() {
    return fail(Error::Code::Corrupt, "it has changed since it was read",
                "open the dataset again once nobody writes it");
}

} // namespace

Result<std::vector<std::byte>> ChunkObjects::read(const ZarrArray& array,
                                                  const std::vector<std::uint64_t>& at,
                                                  const std::stop_token& stop) const {
    const std::string name = array.path_of(at);
    return read_object(array, name, stop).map_error([&](Error error) {
        error.message = "chunk " + name + ": " + error.message;
        return error;
    });
}

Result<std::vector<std::byte>> ChunkObjects::read_object(const ZarrArray& array,
                                                         const std::string& name,
                                                         const std::stop_token& stop) const {
    const auto file = root_ / name;
    const auto before = disk_->identity(file);
    if (!before && before.error().code == Error::Code::NotFound) {
        if (auto same = check_same(name, {}); !same)
            return tl::unexpected(same.error());
        if (!array.fill)
            return fail(Error::Code::NotFound, "it is not there, and fill_value is null");
        return std::vector<std::byte>();
    }
    if (!before)
        return tl::unexpected(before.error());
    const std::size_t most = most_stored_bytes(array);
    if (before->size > most || (array.coders.empty() && before->size != most))
        return fail(Error::Code::Corrupt,
                    "it has " + std::to_string(before->size) + " bytes instead of " +
                        (array.coders.empty() ? "" : "at most ") + std::to_string(most),
                    "write that chunk again");
    if (auto same = check_same(name, *before); !same)
        return tl::unexpected(same.error());
    std::vector<std::byte> stored(static_cast<std::size_t>(before->size));
    if (auto got = disk_->read_stoppable(file, 0, stored, stop); !got)
        return tl::unexpected(got.error());
    if (const auto after = disk_->identity(file); !after || *after != *before)
        return changed();
    return unpack_chunk(array, std::move(stored));
}

// A missing object counts as one without bytes.
Result<void> ChunkObjects::check_same(const std::string& name,
                                      const core::FileIdentity& now) const {
    const std::scoped_lock lock(mutex_);
    if (!(seen_.try_emplace(name, now).first->second == now))
        return changed();
    return {};
}

Result<std::vector<double>> ChunkObjects::read_line(const ZarrArray& array,
                                                    std::uint64_t most) const {
    if (array.shape.size() != 1)
        return fail(Error::Code::Unsupported, array.name + " has more than one axis");
    if (array.shape[0] > most)
        return fail(Error::Code::OverLimit, array.name + " has " + std::to_string(array.shape[0]) +
                                                " numbers, which is more than " +
                                                std::to_string(most));
    if (array.chunks[0] > most)
        return fail(Error::Code::OverLimit,
                    array.name + " has chunks of " + std::to_string(array.chunks[0]) + " numbers");
    if (array.chunks_along(0) > most_objects_a_line)
        return core::over_limit(most_objects_a_line,
                                array.name + " lies in " + std::to_string(array.chunks_along(0)) +
                                    " chunks, and coordinates may lie in " +
                                    std::to_string(most_objects_a_line),
                                "write it in larger chunks");
    std::vector<double> out;
    for (std::uint64_t chunk = 0; out.size() < array.shape[0]; ++chunk) {
        const auto bytes = read(array, {chunk}, {});
        if (!bytes)
            return tl::unexpected(bytes.error());
        std::vector<double> values = bytes->empty()
                                         ? std::vector<double>(array.chunks[0], filled_value(array))
                                         : read_numbers(array, *bytes);
        values.resize(std::min<std::size_t>(values.size(), array.shape[0] - out.size()));
        out.insert(out.end(), values.begin(), values.end());
    }
    return out;
}

} // namespace wakesurf::server
