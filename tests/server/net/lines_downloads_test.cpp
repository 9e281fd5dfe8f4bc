// Streamlines over HTTP: from an address to the lines, and the words for what cannot be had.
#include "protocol/wire/lines_file.hpp"
#include "server/net/download_request.hpp"
#include "server/net/lines_downloads.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::server::lines_downloads_test {

namespace {

std::string refusal(const std::string& query) {
    const auto read = url_query(query).and_then(read_lines_query);
    return read ? "" : read.error().message;
}

} // namespace

TEST(LinesDownloads, ReadSeedsAndEndsFromAnAddress) {
    const auto read = value_of(url_query("from=sphere:1,2,3%3A0.5&seeds=7&direction=backward&"
                                         "duration=2&length=3&field=p%20rgh&time=2.5")
                                   .and_then(read_lines_query));
    EXPECT_EQ(read.seeds, (core::LineSeeds{core::LineSeeds::Kind::Sphere, {{1, 2, 3}}, 0.5, 7}));
    const auto off =
        value_of(url_query("patch=hull%0Ain%20let&from=walls:0.1").and_then(read_lines_query));
    EXPECT_EQ(off.seeds.patches, (std::vector<std::string>{"hull", "in let"}));
    EXPECT_EQ(read.direction, core::Direction::Backward);
    EXPECT_EQ(read.duration, 2.0);
    EXPECT_EQ(read.length, 3.0);
    EXPECT_EQ(read.field, "p rgh");
    EXPECT_EQ(read.time, 2.5);
}

TEST(LinesDownloads, NameTheFaultOfAnAddress) {
    EXPECT_EQ(refusal("field=p"), "`from` is missing");
    const std::string from = "from=walls:1&";
    for (const char* seeds : {"0", "4097", "-1", "many", "1.5"})
        EXPECT_EQ(refusal(from + "seeds=" + seeds), "`seeds` is not a whole number from 1 to 4096");
    EXPECT_EQ(refusal(from + "time=nan"), "`time` is not a finite number");
    EXPECT_EQ(refusal(from + "length=-1"), "`length` is not a number from 0");
    EXPECT_EQ(refusal(from + "direction=up"), "`direction` is not forward, backward or both");
    EXPECT_NE(refusal(from + "step=1").find("no parameter `step`"), std::string::npos);
    for (const char* wrong : {"line:0,0,0", "plane:0,0,0:1,0,0", "sphere:0,0,0", "walls", "", "x:1",
                              "sphere:0,0,0:nan", "line:0,0,0:1,0,0:1,1,1"})
        EXPECT_NE(refusal(std::string("from=") + wrong).find("is neither line:"), std::string::npos)
            << wrong;
}

TEST(LinesDownloads, HaveTheLinesOfAFlowAtATimeAndSayWhatCannotBeHad) {
    const tests::ServerProcess server(
        {"flow:rotation?omega=2,w=0", "flow:double-gyre", "flow:sphere?a=0.5"});
    const auto get = [&](const std::string& query, const std::string& dataset = "rotation") {
        return tests::http(server.port(), "GET",
                           "/api/v1/datasets/" + dataset + "/lines.bin?" + query, server.bearer());
    };
    const tests::HttpReply reply =
        get("from=line:0.5,0,1:1,0,1&seeds=3&duration=1&field=velocity_y");
    ASSERT_EQ(reply.status, 200) << reply.body;
    const auto file = value_of(protocol::read_lines_file(std::as_bytes(std::span(reply.body))));
    ASSERT_EQ(file.lines.lines(), 3u);
    for (std::size_t i = 0; i < file.lines.offsets[1]; ++i) {
        EXPECT_NEAR(std::hypot(file.lines.points[i].x, file.lines.points[i].y), 0.5, 1e-4);
        EXPECT_NEAR(file.lines.values[i], 2.0 * file.lines.points[i].x, 1e-3);
    }
    const tests::HttpReply walls = get("from=walls:0.1&seeds=40", "sphere");
    ASSERT_EQ(walls.status, 200) << walls.body;
    EXPECT_EQ(
        value_of(protocol::read_lines_file(std::as_bytes(std::span(walls.body)))).lines.lines(),
        40u);
    const tests::HttpReply along = get("from=along&seeds=40&length=0.3", "sphere");
    ASSERT_EQ(along.status, 200) << along.body;
    const auto on = value_of(protocol::read_lines_file(std::as_bytes(std::span(along.body))));
    EXPECT_EQ(on.lines.lines(), 40u);
    for (const core::Vec3& each : on.lines.points)
        EXPECT_NEAR(glm::length(each), 0.5, 0.01) << "its radius";
    const auto expect = [](const tests::HttpReply& refused, int status, const char* words) {
        EXPECT_EQ(refused.status, status) << refused.body;
        EXPECT_NE(refused.body.find(words), std::string::npos) << refused.body;
    };
    expect(get("from=line:99,0,0:99,1,0"), 400, "in x it goes from -10 to 10");
    expect(get("from=sphere:0,0,0:1e-30"), 400, "no radius");
    expect(get("from=walls:0.1"), 404, "no obstacle");
    expect(get("from=along"), 404, "no obstacle");
    expect(get("from=walls:0.1&patch=hull", "sphere"), 404, "there is no patch hull");
    expect(get("from=line:0,0,0:1,0,0&field=p"), 404, "a field the dataset does not have: p");
    expect(get("from=line:0,0,0:1,0,0", "none"), 404, "there is no dataset of this name");
    expect(get("from=line:0.5,0.5,0.5:1,0.5,0.5", "double-gyre"), 400, "`time` is missing");
}

} // namespace wakesurf::server::lines_downloads_test
