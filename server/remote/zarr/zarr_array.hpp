// An array of Zarr: its type, chunks and compression. Values only: server/remote/zarr/zarr_metadata.hpp
// reads them, server/remote/zarr/zarr_chunk.hpp the bytes of chunks.
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

    /// Names a step from the bytes of a chunk's object to its numbers.
    enum class Coder { Zlib, Blosc, Zstd, Crc32c };

    std::string name;                  ///< its folder below the root; empty: the root itself
    std::vector<std::uint64_t> shape;  ///< at least one axis, slowest first
    std::vector<std::uint64_t> chunks; ///< numbers an axis of a chunk, at least 1
    Number number = Number::Float;     ///< what the numbers are
    std::size_t number_bytes = 4;      ///< 1, 2, 4 or 8; of Float at least 2
    bool big_endian = false;           ///< most significant byte first
    std::vector<Coder> coders;         ///< in the order of reading
    std::optional<double> fill;        ///< of missing chunks; empty: those are errors
    std::string key_prefix;            ///< of the names of chunks: "" or "c"
    char separator = '.';              ///< between the numbers in them, "." or "/"

    /// The names of the axes; empty if they have none.
    std::vector<std::string> dimensions;
    std::string unit;            ///< attribute `units`
    std::vector<double> missing; ///< stored numbers that stand for a missing value
    bool missing_is_nan = false; ///< an attribute declares NaN such a number
    double scale = 1.0;          ///< a value is scale * number + offset
    double offset = 0.0;         ///< likewise

    /// Returns the numbers of a chunk.
    std::uint64_t chunk_numbers() const;

    /// Returns the bytes of a chunk's numbers.
    std::size_t chunk_bytes() const {
        return static_cast<std::size_t>(chunk_numbers()) * number_bytes;
    }

    /// Returns the number of chunks along an axis.
    std::uint64_t chunks_along(std::size_t axis) const {
        return shape[axis] / chunks[axis] + (shape[axis] % chunks[axis] != 0 ? 1 : 0);
    }

    /// Returns the name of a chunk's object below the array's folder. @param at  one number an axis
    std::string key(const std::vector<std::uint64_t>& at) const;

    /// Returns its name below the root.
    std::string path_of(const std::vector<std::uint64_t>& at) const {
        return name.empty() ? key(at) : name + "/" + key(at);
    }

    /// Says whether values may be missing: by declared numbers, or by a fill value of NaN.
    bool may_miss_values() const;
};

/// Says whether a name can stand in a path or an address unchanged, and stays inside of it.
bool is_plain_name(std::string_view name);

} // namespace wakesurf::server
