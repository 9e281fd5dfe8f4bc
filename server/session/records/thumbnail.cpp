#include "server/session/records/thumbnail.hpp"

#include "server/limits.hpp"

#include <openssl/evp.h>

#include <algorithm>
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

} // namespace

core::Result<Thumbnail> read_thumbnail(std::string_view base64) {
    if (base64.size() > (limits::thumbnail_bytes + 2) / 3 * 4)
        return core::over_limit(limits::thumbnail_bytes,
                                "the picture is larger than " +
                                    std::to_string(limits::thumbnail_bytes) + " bytes",
                                "make it smaller: it is shown some 200 pixels wide");
    auto bytes = decoded(base64);
    const std::string_view type = bytes ? type_of(*bytes) : std::string_view{};
    if (type.empty())
        return fail(Error::Code::InvalidArgument,
                    "`image` is not the base64 text of a PNG, JPEG or WebP picture",
                    "send the part of a data URL after the comma");
    return Thumbnail{std::string(type), std::move(*bytes)};
}

} // namespace wakesurf::server
