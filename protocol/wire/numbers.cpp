#include "protocol/wire/numbers.hpp"

#include "protocol/wire/bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>

namespace wakesurf::protocol {

namespace {

using core::Error;

constexpr int level = 6;
/// Deflate expands by this factor at most.
constexpr std::uint64_t most_inflation = 1032;

const Bytef* zlib_in(std::span<const std::byte> bytes) {
    return reinterpret_cast<const Bytef*>(bytes.data());
}

/// Deflates with a window no larger than the input: zlib clears its memory, which costs more than a small
/// update.
core::Result<Bytes> deflated(std::span<const std::byte> bytes) {
    z_stream stream{};
    const int window = std::clamp(static_cast<int>(std::bit_width(bytes.size())), 9, 15);
    if (deflateInit2(&stream, level, Z_DEFLATED, -window, std::clamp(window - 6, 3, 9),
                     Z_DEFAULT_STRATEGY) != Z_OK)
        return core::fail(Error::Code::OverLimit, "not enough memory to encode a mesh update",
                          "ask for fewer quads");
    Bytes out(deflateBound(&stream, static_cast<uLong>(bytes.size())));
    stream.next_in = const_cast<Bytef*>(zlib_in(bytes)); // zlib's name for what it only reads
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

/// Returns exactly `size` bytes, or empty.
std::optional<Bytes> inflated(std::span<const std::byte> bytes, std::size_t size) {
    z_stream stream{};
    if (inflateInit2(&stream, -15) != Z_OK)
        return std::nullopt;
    Bytes out(size + 1);
    stream.next_in = const_cast<Bytef*>(zlib_in(bytes));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const bool whole = inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.total_out == size &&
                       stream.avail_in == 0;
    inflateEnd(&stream);
    out.resize(size);
    return whole ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace

core::Result<Bytes> pack_numbers(std::span<const std::uint32_t> numbers) {
    Bytes varints;
    varints.reserve(numbers.size() + numbers.size() / 4);
    for (const std::uint32_t number : numbers)
        append_varint(varints, number);
    return deflated(varints).map([&](const Bytes& packed) {
        Bytes bytes;
        append_varint(bytes, static_cast<std::uint32_t>(packed.size()));
        append_varint(bytes, static_cast<std::uint32_t>(varints.size()));
        bytes.insert(bytes.end(), packed.begin(), packed.end());
        return bytes;
    });
}

core::Result<Numbers> unpack_numbers(std::span<const std::byte>& update) {
    std::size_t begin = 0;
    const auto packed = take_varint(update, begin);
    const auto size = packed ? take_varint(update, begin) : std::nullopt;
    if (!size || *packed > update.size() - begin || *size > most_inflation * *packed)
        return corrupt("a mesh update ends within its numbers");
    const auto varints = inflated(update.subspan(begin, *packed), *size);
    if (!varints)
        return corrupt("the numbers of a mesh update are damaged");
    std::vector<std::uint32_t> numbers;
    numbers.reserve(varints->size());
    for (std::size_t at = 0; at < varints->size();) {
        const auto number = take_varint(*varints, at);
        if (!number)
            return corrupt("a mesh update holds a number that is cut off or has more than 32 bits");
        numbers.push_back(*number);
    }
    update = update.subspan(begin + *packed);
    return Numbers(std::move(numbers));
}

} // namespace wakesurf::protocol
