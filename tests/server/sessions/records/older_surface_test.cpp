// Surfaces kept before API level 5, when `backward` went back from `from` whichever way `to` lay.
#include "server/sessions/records/older_surface.hpp"
#include "server/sessions/records/record_entries.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::older_surface_test {

namespace {

JournalEntry kept(const std::string& id, const std::string& more) {
    return {"surface", id,
            R"({"surface":")" + id + R"(","rev":3,"epoch":2,"rake":"r1","dataset":"d",)" + more +
                "}"};
}

KeptRecords read(const std::vector<JournalEntry>& surfaces) {
    std::vector<JournalEntry> entries = surfaces;
    entries.push_back({"rake", "r1",
                       R"({"rake":"r1","rev":1,"kind":"line","points":[[0,0,0],[1,0,0]],)"
                       R"("seeds":8,"name":"","colour":"#0072b2","author":""})"});
    return read_entries(entries);
}

const core::SurfaceParameters& parameters(const KeptRecords& records, const std::string& id) {
    return records.records.find<protocol::SurfaceRecord>(id)->parameters;
}

} // namespace

TEST(OlderSurface, ThatWentBackToALaterTimeIsReadAsTheSurfaceItWas) {
    const auto records = read({
        kept("s1", R"("kind":"path","direction":"backward","from":5,"to":8)"),
        kept("s2", R"("kind":"streak","direction":"backward","from":15,"to":20,"releaseUntil":17)"),
        kept("s3", R"("kind":"path","direction":"backward","from":5,"to":2)"),
        kept("s4", R"("kind":"path","direction":"both","from":5,"to":8)"),
        kept("s5", R"("kind":"stream","from":5,"to":8)"),
    });
    ASSERT_TRUE(records.report.refused.empty()) << records.report.refused.front().error.message;
    EXPECT_EQ(parameters(records, "s1").to, 2.0);
    EXPECT_EQ(parameters(records, "s1").direction, core::Direction::Backward);
    EXPECT_EQ(parameters(records, "s2").to, 10.0);
    EXPECT_EQ(parameters(records, "s2").release_until, 13.0);
    EXPECT_EQ(parameters(records, "s3").to, 2.0);
    EXPECT_EQ(parameters(records, "s4").to, 8.0);
    EXPECT_EQ(parameters(records, "s4").direction, core::Direction::Both);
    EXPECT_EQ(parameters(records, "s5").direction, core::Direction::Forward);
}

TEST(OlderSurface, OfTwoTimesInOneMeshIsKeptAsideInWords) {
    const auto records = read({
        kept("s1", R"("kind":"streak","direction":"both","from":3,"to":6)"),
        kept("s2", R"("kind":"time","direction":"both","from":3,"to":6,"sweep":[0,1,0])"),
        kept("s3", R"("kind":"path","direction":"forward","from":3,"to":2)"),
    });
    ASSERT_EQ(records.report.refused.size(), 3U);
    EXPECT_NE(records.report.refused[0].error.message.find("stream and path surfaces"),
              std::string::npos)
        << records.report.refused[0].error.message;
    EXPECT_EQ(records.records.find<protocol::SurfaceRecord>("s1"), nullptr);
}

TEST(OlderSurface, ConvertedOnceStaysAsItIs) {
    core::SurfaceParameters p;
    p.kind = core::SurfaceKind::Path;
    p.from = 5.0;
    p.to = 8.0;
    p.direction = core::Direction::Backward;
    const auto today = from_older(p);
    EXPECT_EQ(from_older(today), today);
}

} // namespace wakesurf::server::older_surface_test
