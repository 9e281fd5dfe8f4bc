// The address a server prints, as the command line takes it.
#include "server/app/session_server.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::server::server_address_test {

TEST(ServerAddress, IsTakenApart) {
    const auto plain = parse_server_address("http://127.0.0.1:8080/#token=abc");
    ASSERT_TRUE(plain);
    EXPECT_FALSE(plain->tls);
    EXPECT_EQ(plain->authority(), "127.0.0.1:8080");
    EXPECT_EQ(plain->token, "abc");
    const auto shared = parse_server_address("https://lab.example/#session=session-3&token=k");
    ASSERT_TRUE(shared);
    EXPECT_TRUE(shared->tls);
    EXPECT_EQ(shared->authority(), "lab.example:443");
    EXPECT_EQ(shared->token, "k");
    const auto v6 = parse_server_address("http://[::1]:9/");
    ASSERT_TRUE(v6);
    EXPECT_EQ(v6->host, "::1");
    EXPECT_EQ(v6->authority(), "[::1]:9");
    EXPECT_EQ(v6->token, "");
    EXPECT_EQ(v6->prefix, "");
    const auto below = parse_server_address("https://lab.example/user/ada/flow/#token=k");
    ASSERT_TRUE(below);
    EXPECT_EQ(below->authority(), "lab.example:443");
    EXPECT_EQ(below->prefix, "/user/ada/flow");
    EXPECT_EQ(parse_server_address("http://h:80/p")->prefix, "/p");
}

TEST(ServerAddress, OthersAreRefused) {
    for (const char* wrong :
         {"", "nonsense", "ftp://h:1", "http://", "http://:80", "http://h:", "http://h:x",
          "http://h:123456", "http://h/a path", "http://[::1", "http://h/p?q"})
        EXPECT_FALSE(parse_server_address(wrong)) << wrong;
}

} // namespace wakesurf::server::server_address_test
