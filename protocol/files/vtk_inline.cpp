#include "protocol/files/vtk_inline.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <zlib.h>

#include <cstdint>
#include <new>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;
constexpr int fastest = 1; // for floats a higher level saves 3 % and takes three times as long

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string compressed(std::span<const std::byte> block) {
    auto size = compressBound(static_cast<uLong>(block.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                  reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()),
                  fastest) != Z_OK)
        throw std::bad_alloc(); // the only possible failure: the buffer is large enough
    out.resize(size);
    return out;
}

void append_base64(std::string& out, std::string_view bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= count ? letters[three >> (18 - 6 * k) & 63u] : '=';
    }
}

} // namespace

std::string vtk_inline(std::span<const std::byte> data) {
    std::vector<std::string> blocks((data.size() + block_bytes - 1) / block_bytes);
    oneapi::tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        const std::size_t first = i * block_bytes;
        blocks[i] = compressed(data.subspan(first, std::min(block_bytes, data.size() - first)));
    });
    std::vector<std::uint64_t> header{blocks.size(), block_bytes, data.size() % block_bytes};
    std::string all;
    for (std::string& block : blocks) {
        header.push_back(block.size());
        all += block;
        block = {};
    }
    std::string out;
    append_base64(out, text_of(std::as_bytes(std::span(header))));
    append_base64(out, all);
    return out;
}

} // namespace wakesurf::protocol
