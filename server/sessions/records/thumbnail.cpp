#include "server/sessions/records/thumbnail.hpp"

#include "server/base/limits.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

std::optional<std::string> decoded(std::string_view base64) {
    if (base64.empty() || base64.size() % 4 != 0)
        return std::nullopt;
    const std::size_t padding =
        base64.ends_with("==") ? 2 : static_cast<std::size_t>(base64.ends_with('='));
    // OpenSSL passes over blanks and line ends, which are not base64 here.
    if (std::any_of(base64.begin(), base64.end(), [](char c) { return c <= ' '; }))
        return std::nullopt;
    std::string bytes(base64.size() / 4 * 3, '\0');
    const int length = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                       reinterpret_cast<const unsigned char*>(base64.data()),
                                       static_cast<int>(base64.size()));
    if (length < 0)
        return std::nullopt;
    bytes.resize(static_cast<std::size_t>(length) - padding);
    return bytes;
}

std::string_view type_of(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv))
        return "image/png";
    if (bytes.starts_with("\xff\xd8\xff"sv))
        return "image/jpeg";
    if (bytes.starts_with("RIFF"sv) &&
        bytes.substr(std::min<std::size_t>(bytes.size(), 8)).starts_with("WEBP"sv))
        return "image/webp";
    return {};
}

/// A client that shows the picture unpacks all of its pixels.
constexpr std::uint64_t most_pixels = 1'000'000;

/// Reads a number of so many bytes; 0 where the picture ends before it.
std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < count && at + count <= bytes.size(); ++i)
        out = out << 8 | static_cast<unsigned char>(bytes[at + i]);
    return out;
}

std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t out = 0;
    for (std::size_t i = count; i > 0 && at + count <= bytes.size(); --i)
        out = out << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
    return out;
}

struct PixelSize {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
};

// The first start of a frame: behind segments of a marker and a length each. (ITU-T T.81, annex B)
PixelSize size_of_jpeg(std::string_view bytes) {
    for (std::size_t at = 2; big_endian(bytes, at, 1) == 0xff;) {
        const auto marker = big_endian(bytes, at + 1, 1);
        const bool table = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
        if (marker >= 0xc0 && marker <= 0xcf && !table)
            return {big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
        const auto length = big_endian(bytes, at + 2, 2);
        at += marker == 0xff ? 1 : 2 + std::max(length, 2u); // 0xff: a fill byte
    }
    return {};
}

// Lossy, lossless, or extended with a canvas. (RFC 9649)
PixelSize size_of_webp(std::string_view bytes) {
    const auto kind = bytes.substr(std::min<std::size_t>(bytes.size(), 12), 4);
    if (kind == "VP8X" && bytes.size() >= 30)
        return {little_endian(bytes, 24, 3) + 1, little_endian(bytes, 27, 3) + 1};
    if (kind == "VP8L" && bytes.size() >= 25) {
        const auto both = little_endian(bytes, 21, 4);
        return {(both & 0x3fff) + 1, (both >> 14 & 0x3fff) + 1};
    }
    if (kind == "VP8 ")
        return {little_endian(bytes, 26, 2) & 0x3fff, little_endian(bytes, 28, 2) & 0x3fff};
    return {};
}

PixelSize size_of(std::string_view type, std::string_view bytes) {
    if (type == "image/png") // its first chunk says it (ISO/IEC 15948)
        return {big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
    return type == "image/jpeg" ? size_of_jpeg(bytes) : size_of_webp(bytes);
}

} // namespace

core::Result<Thumbnail> read_thumbnail(std::string_view base64) {
    if (base64.size() > (limits::thumbnail_bytes + 2) / 3 * 4)
        return core::over_limit(limits::thumbnail_bytes,
                                "the picture is larger than " +
                                    std::to_string(limits::thumbnail_bytes) + " bytes",
                                "make it smaller: it is shown some 200 pixels wide");
    auto bytes = decoded(base64);
    const std::string_view type = bytes ? type_of(*bytes) : std::string_view{};
    const PixelSize size = type.empty() ? PixelSize{} : size_of(type, *bytes);
    if (size.width > most_pixels || size.height > most_pixels ||
        size.width * size.height > most_pixels)
        return core::over_limit(most_pixels,
                                "the picture has " + std::to_string(size.width) + " x " +
                                    std::to_string(size.height) + " pixels",
                                "make it smaller: it is shown some 200 pixels wide");
    if (size.width == 0 || size.height == 0)
        return fail(Error::Code::InvalidArgument,
                    "`image` is not the base64 text of a PNG, JPEG or WebP picture",
                    "send the part of a data URL after the comma");
    return Thumbnail{std::string(type), std::move(*bytes)};
}

} // namespace wakesurf::server
