// The parameters of a file of numbers.
#include "server/net/number_downloads.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::number_downloads_test {

namespace {

std::string refusal(const std::string& query) {
    const auto read = url_query(query).and_then(read_numbers);
    return read ? "" : read.error().message;
}

} // namespace

TEST(NumberDownloads, ReadTimesAndAPlaneOrABoxFromAnAddress) {
    const auto read =
        value_of(url_query("times=0:5:0.5&through=plane%3A0,0,0%3A0,0,2").and_then(read_numbers));
    EXPECT_EQ(read.times->every, 0.5);
    EXPECT_EQ(std::get<core::Plane>(*read.through).height({0, 0, 3}), 3.0);
    EXPECT_TRUE(value_of(url_query("time=end").and_then(read_numbers)).shown.at_the_end);
    EXPECT_FALSE(value_of(url_query("").and_then(read_numbers)).through);
    EXPECT_EQ(value_of(url_query("fields=u,%20v%0Ap%0A").and_then(read_numbers)).fields,
              (std::vector<std::string>{"u, v", "p"}));
}

TEST(NumberDownloads, NameTheFaultOfAnAddress) {
    EXPECT_NE(refusal("time=1&times=0:1:1").find("exclude each other"), std::string::npos);
    EXPECT_NE(refusal("draco=false").find("`draco`"), std::string::npos);
    EXPECT_NE(refusal("times=0:1").find("`times`"), std::string::npos);
    EXPECT_NE(refusal("through=box:0,0,0:0,1,1").find("flat"), std::string::npos);
    EXPECT_NE(refusal("time=soon").find("`time`"), std::string::npos);
    std::string fields = "fields=p";
    for (int i = 0; i < 64; ++i)
        fields += "%0Ap";
    EXPECT_NE(refusal(fields).find("`fields` names more than 64"), std::string::npos);
}

} // namespace wakesurf::server::number_downloads_test
