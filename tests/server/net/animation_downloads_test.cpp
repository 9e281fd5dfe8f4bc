// The parameters of an animation.
#include "server/net/animation_downloads.hpp"
#include "server/net/download_request.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::animation_downloads_test {

namespace {

std::string refusal(const std::string& query) {
    const auto read = url_query(query).and_then(read_animation);
    return read ? "" : read.error().message;
}

} // namespace

TEST(AnimationDownloads, ReadTimesAndALookFromAnAddress) {
    const auto read = value_of(
        url_query("times=0:5:0.5&look=%7B%22map%22%3A%22grey%22%7D").and_then(read_animation));
    EXPECT_EQ(read.times->every, 0.5);
    EXPECT_EQ(read.look, R"({"map":"grey"})");
    EXPECT_FALSE(value_of(url_query("").and_then(read_animation)).times);
}

TEST(AnimationDownloads, NameTheFaultOfAnAddress) {
    EXPECT_NE(refusal("draco=false").find("`draco`"), std::string::npos);
    EXPECT_NE(refusal("times=0:1").find("`times`"), std::string::npos);
    EXPECT_NE(refusal("look=viridis").find("`look`"), std::string::npos);
}

} // namespace wakesurf::server::animation_downloads_test
