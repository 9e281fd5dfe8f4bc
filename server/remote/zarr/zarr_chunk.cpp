#include "server/remote/zarr/zarr_chunk.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"

#include <blosc.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;
using Bytes = std::vector<std::byte>;
using Number = ZarrArray::Number;

namespace {

constexpr std::size_t sum_bytes = sizeof(std::uint32_t);
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

tl::unexpected<Error> damaged(std::string what) {
    return fail(Error::Code::Corrupt, std::move(what), "write that chunk again");
}

Result<Bytes> inflated(const Bytes& stored, std::size_t wanted) {
    z_stream stream{};
    constexpr int zlib_or_gzip = 32 + MAX_WBITS;
    if (inflateInit2(&stream, zlib_or_gzip) != Z_OK)
        return fail(Error::Code::OverLimit, "there is not enough memory to unpack it");
    Bytes out(wanted);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(stored.data()));
    stream.avail_in = static_cast<uInt>(stored.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const int ended = inflate(&stream, Z_FINISH);
    const std::string why = stream.msg != nullptr ? std::string(": ") + stream.msg : "";
    const bool whole = ended == Z_STREAM_END && stream.avail_out == 0;
    inflateEnd(&stream);
    if (!whole)
        return damaged("zlib cannot unpack it" + why);
    return out;
}

Result<Bytes> unblosced(const Bytes& stored, std::size_t wanted) {
    std::size_t bytes = 0;
    if (blosc_cbuffer_validate(stored.data(), stored.size(), &bytes) < 0)
        return damaged("c-blosc cannot unpack it");
    if (bytes != wanted)
        return damaged("c-blosc unpacks it to " + std::to_string(bytes) + " bytes instead of " +
                       std::to_string(wanted));
    Bytes out(wanted);
    const int unpacked = blosc_decompress_ctx(stored.data(), out.data(), out.size(), 1);
    if (unpacked < 0 || static_cast<std::size_t>(unpacked) != wanted)
        return damaged("c-blosc cannot unpack it");
    return out;
}

Result<Bytes> unzstded(const Bytes& stored, std::size_t wanted) {
    Bytes out(wanted);
    const std::size_t unpacked =
        ZSTD_decompress(out.data(), out.size(), stored.data(), stored.size());
    if (ZSTD_isError(unpacked) != 0)
        return damaged(std::string("zstd cannot unpack it: ") + ZSTD_getErrorName(unpacked));
    if (unpacked != wanted)
        return damaged("zstd unpacks it to " + std::to_string(unpacked) + " bytes instead of " +
                       std::to_string(wanted));
    return out;
}

Result<Bytes> without_sum(Bytes stored) {
    std::uint32_t said = 0;
    if (stored.size() < sum_bytes)
        return damaged("it is shorter than its checksum");
    std::memcpy(&said, stored.data() + stored.size() - sum_bytes, sum_bytes);
    stored.resize(stored.size() - sum_bytes);
    if (core::crc32c(stored) != said)
        return damaged("its checksum differs");
    return stored;
}

Result<Bytes> step(ZarrArray::Coder coder, Bytes stored, std::size_t wanted) {
    switch (coder) {
    case ZarrArray::Coder::Zlib:
        return inflated(stored, wanted);
    case ZarrArray::Coder::Blosc:
        return unblosced(stored, wanted);
    case ZarrArray::Coder::Zstd:
        return unzstded(stored, wanted);
    case ZarrArray::Coder::Crc32c:
        break;
    }
    return without_sum(std::move(stored));
}

template <class T>
T load(const std::byte* from, bool big_endian) {
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), from, sizeof(T));
    if (big_endian)
        std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

float float_of_half(std::uint16_t half) {
    float out = 0.0F;
    core::from_half({&half, 1}, {&out, 1});
    return out;
}

/// Calls `use` with a function that reads a number of the array's type.
template <class Use>
void with_reader(const ZarrArray& array, const Use& use) {
    const bool big = array.big_endian;
    const auto as = [&]<class T>(T) {
        use([big](const std::byte* from) { return load<T>(from, big); });
    };
    if (array.number == Number::Float) {
        if (array.number_bytes == 2)
            use([big](const std::byte* from) {
                return float_of_half(load<std::uint16_t>(from, big));
            });
        else if (array.number_bytes == 4)
            as(float{});
        else
            as(double{});
        return;
    }
    const bool with_sign = array.number == Number::Signed;
    switch (array.number_bytes) {
    case 1:
        with_sign ? as(std::int8_t{}) : as(std::uint8_t{});
        break;
    case 2:
        with_sign ? as(std::int16_t{}) : as(std::uint16_t{});
        break;
    case 4:
        with_sign ? as(std::int32_t{}) : as(std::uint32_t{});
        break;
    default:
        with_sign ? as(std::int64_t{}) : as(std::uint64_t{});
    }
}

bool is_missing(const ZarrArray& array, double number) {
    // The metadata have a fill value as a double; one of single precision was rounded when it was stored.
    return std::ranges::any_of(array.missing, [&](double missing) {
        return number == missing || (array.number == Number::Float && array.number_bytes < 8 &&
                                     static_cast<float>(number) == static_cast<float>(missing));
    });
}

bool is_scaled(const ZarrArray& array) {
    return array.scale != 1.0 || array.offset != 0.0;
}

double value_of(const ZarrArray& array, double number) {
    if (is_missing(array, number))
        return nothing;
    return is_scaled(array) ? array.scale * number + array.offset : number; // -0 stays -0
}

bool plain(const ZarrArray& array) {
    return array.missing.empty() && !is_scaled(array);
}

} // namespace

std::size_t most_stored_bytes(const ZarrArray& array) {
    constexpr std::size_t coder_headers = 4096;
    return array.coders.empty() ? array.chunk_bytes()
                                : array.chunk_bytes() + array.chunk_bytes() / 64 + coder_headers;
}

std::size_t chunk_reading_bytes(const ZarrArray& array) {
    return array.coders.empty() ? array.chunk_bytes() : 2 * most_stored_bytes(array);
}

Result<Bytes> unpack_chunk(const ZarrArray& array, Bytes stored) {
    std::size_t sums_left =
        static_cast<std::size_t>(std::ranges::count(array.coders, ZarrArray::Coder::Crc32c));
    for (const ZarrArray::Coder coder : array.coders) {
        sums_left -= coder == ZarrArray::Coder::Crc32c ? 1 : 0;
        auto next = step(coder, std::move(stored), array.chunk_bytes() + sums_left * sum_bytes);
        if (!next)
            return next;
        stored = std::move(*next);
    }
    if (stored.size() != array.chunk_bytes())
        return damaged("it has " + std::to_string(stored.size()) + " bytes instead of " +
                       std::to_string(array.chunk_bytes()));
    return stored;
}

bool read_values(const ZarrArray& array,
                 const std::byte* from,
                 std::size_t from_stride,
                 float* to,
                 std::size_t to_stride,
                 std::size_t count) {
    bool finite = true;
    with_reader(array, [&](const auto& number_at) {
        const auto convert = [&](const auto& value_at) {
            for (std::size_t i = 0; i < count; ++i) {
                const float value = value_at(from + i * from_stride);
                finite = finite && std::isfinite(value);
                to[i * to_stride] = value;
            }
        };
        if (plain(array))
            convert([&](const std::byte* at) { return static_cast<float>(number_at(at)); });
        else
            convert([&](const std::byte* at) {
                return static_cast<float>(value_of(array, static_cast<double>(number_at(at))));
            });
    });
    return finite;
}

std::vector<double> read_numbers(const ZarrArray& array, std::span<const std::byte> from) {
    std::vector<double> out(from.size() / array.number_bytes);
    with_reader(array, [&](const auto& number_at) {
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = value_of(array,
                              static_cast<double>(number_at(from.data() + i * array.number_bytes)));
    });
    return out;
}

double filled_value(const ZarrArray& array) {
    return value_of(array, *array.fill);
}

} // namespace wakesurf::server
