// Records read back from a journal.
#include "server/sessions/records/record_entries.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::record_entries_test {

namespace {

JournalEntry kept(const std::string& id, const std::string& more) {
    return {"surface", id,
            R"({"surface":")" + id + R"(","rev":3,"epoch":2,"rake":"r1","dataset":"d",)" + more +
                "}"};
}

StoredRecords read(const std::vector<JournalEntry>& surfaces) {
    std::vector<JournalEntry> entries = surfaces;
    entries.push_back({"rake", "r1",
                       R"({"rake":"r1","rev":1,"kind":"line","points":[[0,0,0],[1,0,0]],)"
                       R"("seeds":8,"name":"","colour":"#0072b2","author":""})"});
    return read_entries(entries);
}

} // namespace

TEST(RecordEntries, LeaveOutSurfacesOfTwoTimesInOneMeshInWords) {
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

} // namespace wakesurf::server::record_entries_test
