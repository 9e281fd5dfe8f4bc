// An array of Zarr: what its numbers are, how they lie in chunks, and by what those are packed. Values only: server/service/zarr/zarr_metadata.hpp reads
// them, server/service/zarr/zarr_chunk.hpp the bytes of chunks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

struct ZarrArray {
    enum class Number { Float, Signed, Unsigned };

    /// A step from the bytes of a chunk's object to its numbers.
    enum class Coder { Zlib, Blosc, Zstd, Crc32c };

    std::string name;                  ///< its folder below the root; empty: the root itself
    std::vector<std::uint64_t> shape;  ///< at least one axis, slowest first
    std::vector<std::uint64_t> chunks; ///< numbers an axis of a chunk, at least 1
    Number number = Number::Float;     ///< what the numbers are
    std::size_t number_bytes = 4;      ///< 1, 2, 4 or 8; of Float at least 2
    bool big_endian = false;           ///< most significant byte first
    std::vector<Coder> coders;         ///< in the order of reading
    std::optional<double> fill;        ///< of chunks that are not there; nothing: such are missed
    std::string key_prefix;            ///< of the names of chunks: "" or "c"
    char separator = '.';              ///< between the numbers in them, "." or "/"

    std::vector<std::string> dimensions; ///< one an axis, or none where they have no names
    std::string unit;                    ///< attribute `units`
    std::vector<double> missing;         ///< stored numbers that mean: no value
    bool missing_is_nan = false;         ///< an attribute says that NaN means that
    double scale = 1.0;                  ///< a value is scale * number + offset
    double offset = 0.0;                 ///< likewise

    /// Numbers of a chunk.
    std::uint64_t chunk_numbers() const;

    /// Bytes of a chunk's numbers.
    std::size_t chunk_bytes() const {
        return static_cast<std::size_t>(chunk_numbers()) * number_bytes;
    }

    /// Chunks along an axis.
    std::uint64_t chunks_along(std::size_t axis) const {
        return shape[axis] / chunks[axis] + (shape[axis] % chunks[axis] != 0 ? 1 : 0);
    }

    /// The name of a chunk's object below the array's folder. @param at  one number an axis
    std::string key(const std::vector<std::uint64_t>& at) const;

    /// The same below the root.
    std::string path_of(const std::vector<std::uint64_t>& at) const {
        return name.empty() ? key(at) : name + "/" + key(at);
    }

    /// Some values may be none: numbers that mean that, or numbers of float that are filled with NaN.
    bool may_miss_values() const;
};

/// It may stand in a path or an address as it is, and leads nowhere else.
bool is_plain_name(std::string_view name);

} // namespace wakesurf::server
