// What is kept of a session besides its records: it comes back as it was, and what is damaged is noticed.
#include "protocol/api/record_text.hpp"
#include "protocol/api/utc_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::protocol::session_profile_test {

TEST(SessionProfile, ComesBackAsItWas) {
    SessionProfile profile{
        1'800'000'000, 1'800'000'060, true, true, {{"p1", "Ada", "#102030"}}, {}};
    EXPECT_EQ(*parse_profile(record_text(profile)), profile);
    profile.created.reset();
    profile.deleted = 1'800'000'100;
    profile.people.assign(most_session_people, {"p2", "B\u00f6b \"q\"", ""});
    EXPECT_EQ(*parse_profile(record_text(profile)), profile);
}

TEST(SessionProfile, WhatIsNoneIsNoticed) {
    const std::string good =
        record_text(SessionProfile{1, 2, false, false, {{"p1", "Ada", ""}}, {}});
    ASSERT_TRUE(parse_profile(good));
    const auto with = [&good](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    for (const std::string& text :
         {std::string(), std::string("[]"), std::string("7"),
          with("\"edited\":false", "\"edited\":0"), with("\"lastUsed\":2", "\"lastUsed\":-1"),
          with("\"lastUsed\":2", "\"lastUsed\":1e99"),
          with("\"lastUsed\":2", "\"lastUsed\":253402300800"),
          with("\"created\":1", "\"created\":\"x\""), with("\"people\":[", "\"people\":[7,"),
          with("\"name\":\"Ada\"", "\"name\":7"), with("\"people\"", "\"persons\"")}) {
        const auto read = parse_profile(text);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, core::Error::Code::Corrupt) << text;
    }
}

TEST(UtcText, IsRfc3339) {
    EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00Z");
    EXPECT_EQ(utc_text(1'800'000'000), "2027-01-15T08:00:00Z");
    EXPECT_EQ(utc_text(last_utc_second), "9999-12-31T23:59:59Z");
}

} // namespace wakesurf::protocol::session_profile_test
