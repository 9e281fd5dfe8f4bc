#include "tests/support/vtp_arrays.hpp"

#include <zlib.h>

#include <cstdint>
#include <stdexcept>

namespace wakesurf::tests {

namespace {

void require(bool right, const char* what) {
    if (!right)
        throw std::runtime_error(what);
}

std::string decoded(const std::string& base64) {
    static const std::string letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    require(base64.size() % 4 == 0, "base64 comes in fours");
    std::string out;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : base64) {
        if (c == '=')
            break;
        const auto value = letters.find(c);
        require(value != std::string::npos, "a letter that is none of base64");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8)
            out += static_cast<char>(bits >> (count -= 8) & 255);
    }
    return out;
}

std::uint64_t word(const std::string& bytes, std::size_t i) {
    std::uint64_t value = 0;
    require(bytes.size() >= 8 * (i + 1), "the header ends early");
    std::memcpy(&value, bytes.data() + 8 * i, sizeof value);
    return value;
}

} // namespace

std::string vtp_bytes(const std::string& file, const std::string& type, const std::string& name) {
    const auto tag = file.find("<DataArray type=\"" + type + "\" Name=\"" + name + "\"");
    if (tag == std::string::npos)
        return {};
    const auto start = file.find('>', tag) + 1;
    require(file.substr(tag, start - tag).ends_with("format=\"binary\">"),
            "the array is not inline");
    const std::string text = file.substr(start, file.find('<', start) - start);
    // The header's first word states its length.
    const auto blocks = word(decoded(text.substr(0, 12)), 0);
    const std::size_t header_text = (8 * (3 + blocks) + 2) / 3 * 4;
    const std::string header = decoded(text.substr(0, header_text));
    const std::string data = decoded(text.substr(header_text));
    std::string out;
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < blocks; ++i) {
        const bool partial = i + 1 == blocks && word(header, 2) > 0;
        auto size = static_cast<uLong>(word(header, partial ? 2 : 1));
        const auto packed = static_cast<uLong>(word(header, 3 + i));
        const auto expected = size;
        std::string block(size, '\0');
        require(at + packed <= data.size(), "the data end early");
        require(uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                           reinterpret_cast<const Bytef*>(data.data() + at), packed) == Z_OK &&
                    size == expected,
                "a block that zlib does not take");
        at += packed;
        out += block;
    }
    require(at == data.size(), "bytes are left over");
    return out;
}

} // namespace wakesurf::tests
