#include "server/net/download_request.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::url_query_test {

using Query = std::map<std::string, std::string>;

TEST(UrlQuery, GivesValuesByNameWithPercentSignsResolved) {
    EXPECT_EQ(url_query("").value(), Query{});
    EXPECT_EQ(url_query("time=2.5&draco=false").value(),
              (Query{{"time", "2.5"}, {"draco", "false"}}));
    EXPECT_EQ(url_query("time=1e%2B05").value(), (Query{{"time", "1e+05"}}));
    EXPECT_EQ(url_query("a=").value(), (Query{{"a", ""}}));
    EXPECT_EQ(url_query("a=b=c&").value(), (Query{{"a", "b=c"}}));
}

TEST(UrlQuery, RefusesWhatCannotBeRead) {
    for (const std::string text :
         {"time", "=1&=2", "a=%", "a=%2", "a=%zz", "a=%-1", "a=1&a=2", "&"})
        EXPECT_EQ(url_query(text).error().code, core::Error::Code::InvalidArgument) << text;
}

} // namespace wakesurf::server::url_query_test
