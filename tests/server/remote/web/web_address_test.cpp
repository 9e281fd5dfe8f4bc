#include "server/remote/web/web_address.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::web_address_test {

TEST(WebAddress, IsThatOfTheFolderInWhichTheManifestIs) {
    for (const char* text : {"https://example.org/a/wake", "https://example.org/a/wake/",
                             "https://example.org/a/wake/store.json"})
        EXPECT_EQ(store_address(text), "https://example.org/a/wake");
    EXPECT_EQ(store_address("http://127.0.0.1:8000/wake"), "http://127.0.0.1:8000/wake");
}

TEST(WebAddress, IsNoFileFolderOrFlow) {
    for (const char* text : {"flow:abc", "wake", "./a//b", "C:/wake", "://x", "/a/https://x"})
        EXPECT_FALSE(is_web_address(text)) << text;
    for (const char* text : {"https://x/y", "HTTP://x/y", "s3://bucket/y", "file:///etc"})
        EXPECT_TRUE(is_web_address(text)) << text;
}

TEST(WebAddress, HasNoOtherSchemeAndHidesNothing) {
    for (const char* text :
         {"file:///etc", "s3://bucket/wake", "ftp://example.org/wake", "HTTPS://example.org/wake",
          "https://", "https://example.org", "https://example.org/", "https:///wake",
          "https://me:secret@example.org/wake", "https://example.org/wake?token=1",
          "https://example.org/wake#a", "https://example.org/a/../wake",
          "https://example.org/a wake", "https://example.org/a\nwake", "https://a\\b/wake"}) {
        const auto address = store_address(text);
        ASSERT_FALSE(address) << *address;
        EXPECT_EQ(address.error().code, core::Error::Code::InvalidArgument) << text;
        EXPECT_EQ(address.error().message.find("secret"), std::string::npos);
    }
}

TEST(WebAddress, MayNameAZarr) {
    EXPECT_EQ(store_address("https://example.org/wake.zarr/"), "https://example.org/wake.zarr");
}

TEST(WebAddress, KnowsWhereAnybodyCouldReadAlong) {
    for (const char* text : {"https://example.org/x", "http://127.0.0.1/x", "http://localhost:80/x",
                             "http://[::1]:80/x"})
        EXPECT_TRUE(is_private_address(text)) << text;
    for (const char* text : {"http://example.org/x", "http://localhost.example.org/x",
                             "http://127.0.0.1.example.org/x", "http://127.0.0.10/x"})
        EXPECT_FALSE(is_private_address(text)) << text;
}

} // namespace wakesurf::server::web_address_test
