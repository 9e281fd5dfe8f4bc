// What a page sends as the picture of a session: how large it would be unpacked is told by its first bytes.
#include "server/sessions/records/thumbnail.hpp"

#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <functional>
#include <vector>

namespace wakesurf::server::thumbnail_test {
namespace {

using namespace std::string_literals;

std::string base64(const std::string& bytes) {
    std::string out(4 * ((bytes.size() + 2) / 3) + 1, '\0');
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                                       reinterpret_cast<const unsigned char*>(bytes.data()),
                                       static_cast<int>(bytes.size()));
    out.resize(static_cast<std::size_t>(length));
    return out;
}

std::string big(unsigned value, int bytes) {
    std::string out;
    for (int i = bytes - 1; i >= 0; --i)
        out.push_back(static_cast<char>(value >> 8 * i & 0xff));
    return out;
}

std::string little(unsigned value, int bytes) {
    const std::string turned = big(value, bytes);
    return {turned.rbegin(), turned.rend()};
}

std::string png(unsigned width, unsigned height) {
    return "\x89PNG\r\n\x1a\n"s + big(13, 4) + "IHDR" + big(width, 4) + big(height, 4) +
           "\x08\x02\0\0\0"s;
}

// With the small picture of a camera before its own size, which does not count.
std::string jpeg(unsigned width, unsigned height) {
    const std::string inner = "\xff\xd8\xff\xc0"s + big(17, 2) + "\x08" + big(9, 2) + big(9, 2);
    const std::string camera =
        "\xff\xe1"s + big(2 + static_cast<unsigned>(inner.size()), 2) + inner;
    const std::string table = "\xff\xff\xc4"s + big(3, 2) + "x";
    return "\xff\xd8"s + camera + table + "\xff\xc2" + big(17, 2) + "\x08" + big(height, 2) +
           big(width, 2);
}

std::string riff(const std::string& chunk) {
    return "RIFF"s + little(100, 4) + "WEBP" + chunk;
}

std::string webp(unsigned width, unsigned height) {
    return riff("VP8 "s + little(50, 4) + "abc\x9d\x01\x2a" + little(width, 2) + little(height, 2));
}

std::string webp_lossless(unsigned width, unsigned height) {
    return riff("VP8L"s + little(50, 4) + "\x2f" + little((width - 1) | (height - 1) << 14, 4));
}

std::string webp_extended(unsigned width, unsigned height) {
    return riff("VP8X"s + little(10, 4) + "\0\0\0\0"s + little(width - 1, 3) +
                little(height - 1, 3));
}

using Maker = std::function<std::string(unsigned, unsigned)>;

const std::vector<Maker> makers{png, jpeg, webp, webp_lossless, webp_extended};

TEST(Thumbnail, IsTakenWhateverItsFormatUpToAMillionPixels) {
    for (const auto& make : makers) {
        EXPECT_EQ(read_thumbnail(base64(make(320, 200)))->bytes, make(320, 200));
        EXPECT_TRUE(read_thumbnail(base64(make(1000, 1000))).has_value());
        const auto refused = read_thumbnail(base64(make(13500, 13500)));
        ASSERT_FALSE(refused.has_value());
        EXPECT_EQ(refused.error().code, core::Error::Code::OverLimit);
        EXPECT_EQ(refused.error().message, "the picture has 13500 x 13500 pixels");
        EXPECT_FALSE(read_thumbnail(base64(make(1000, 1001))).has_value());
    }
    EXPECT_FALSE(read_thumbnail(base64(png(4294967295u, 4294967295u))).has_value());
}

TEST(Thumbnail, ThatDoesNotSayHowLargeItIsIsNone) {
    for (const auto& make : makers)
        for (std::size_t cut = 0; cut < make(320, 200).size(); ++cut) {
            const auto refused = read_thumbnail(base64(make(320, 200).substr(0, cut)));
            // The last bytes of a PNG's header are not looked at.
            if (make(320, 200).starts_with("\x89PNG") && cut >= 24)
                continue;
            ASSERT_FALSE(refused.has_value()) << cut;
            EXPECT_EQ(refused.error().code, core::Error::Code::InvalidArgument) << cut;
        }
    EXPECT_FALSE(read_thumbnail(base64("\xff\xd8\xff\xd9"s + std::string(100, '\xff'))));
    EXPECT_FALSE(read_thumbnail(base64(png(0, 200))));
}

} // namespace
} // namespace wakesurf::server::thumbnail_test
