// The values on a plane over HTTP: from an address to the raster, and the words for what cannot be had.
#include "protocol/wire/slice_file.hpp"
#include "server/net/download_request.hpp"
#include "server/net/slice_downloads.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::server::slice_downloads_test {

namespace {

std::string refusal(const std::string& query) {
    const auto read = url_query(query).and_then(read_slice_query);
    return read ? "" : read.error().message;
}

} // namespace

TEST(SliceDownloads, ReadAPlaneAFieldATimeAndAResolutionFromAnAddress) {
    const auto read = value_of(url_query("plane=1,2,3%3A0,0,2&field=p%20rgh&time=2.5&samples=640")
                                   .and_then(read_slice_query));
    EXPECT_EQ(read.plane.point, core::Vec3(1, 2, 3));
    EXPECT_EQ(read.plane.normal, core::Vec3(0, 0, 1));
    EXPECT_EQ(read.field, "p rgh");
    EXPECT_EQ(read.time, 2.5);
    EXPECT_EQ(read.samples, 640u);
}

TEST(SliceDownloads, NameTheFaultOfAnAddress) {
    EXPECT_EQ(refusal("field=p"), "`plane` is missing");
    EXPECT_NE(refusal("plane=0,0,0").find("`plane`"), std::string::npos);
    EXPECT_NE(refusal("plane=0,0,0:0,0,0").find("has no length"), std::string::npos);
    const std::string plane = "plane=0,0,0:0,0,1&";
    for (const char* samples : {"0", "2049", "-1", "many", "12.5"})
        EXPECT_EQ(refusal(plane + "samples=" + samples),
                  "`samples` is not a whole number from 1 to 2048");
    EXPECT_EQ(refusal(plane + "time=nan"), "`time` is not a finite number");
    EXPECT_NE(refusal(plane + "step=1").find("no parameter `step`"), std::string::npos);
}

TEST(SliceDownloads, HaveTheFieldOfAFlowAtATimeAndSayWhatCannotBeHad) {
    const tests::ServerProcess server({"flow:rotation?omega=2,w=0", "flow:double-gyre"});
    const auto get = [&](const std::string& query, const std::string& dataset = "rotation") {
        return tests::http(server.port(), "GET",
                           "/api/v1/datasets/" + dataset + "/slice.bin?" + query, server.bearer());
    };
    const tests::HttpReply reply = get("plane=0,0,0:0,0,1&samples=21&field=velocity_y");
    ASSERT_EQ(reply.status, 200) << reply.body;
    const auto file = value_of(protocol::read_slice_file(std::as_bytes(std::span(reply.body))));
    const core::SliceRaster& raster = file.raster;
    ASSERT_EQ(raster.columns, 21u);
    for (std::size_t column = 0; column < raster.columns; ++column)
        EXPECT_NEAR(raster.values[column], 2.0 * raster.place(column, 0).x, 1e-3);
    const auto expect = [](const tests::HttpReply& refused, int status, const char* words) {
        EXPECT_EQ(refused.status, status) << refused.body;
        EXPECT_NE(refused.body.find(words), std::string::npos) << refused.body;
    };
    expect(get("plane=0,0,99:0,0,1"), 400, "the plane misses the domain by");
    expect(get("plane=0,0,0:0,0,1&field=p"), 404, "a field the dataset does not have: p");
    expect(get("plane=0,0,0:0,0,1", "none"), 404, "there is no dataset of this name");
    expect(get("plane=1,0.5,0.5:0,0,1", "double-gyre"), 400, "`time` is missing");
    EXPECT_EQ(get("plane=1,0.5,0.5:0,0,1&time=3", "double-gyre").status, 200);
}

TEST(SliceDownloads, HaveAFieldMinusThatOfAnotherDatasetOrTimeAndSayWhatCannotBeSubtracted) {
    const tests::ServerProcess server(
        {"flow:rotation?omega=2,w=0", "flow:rotation?omega=0.5,w=0", "flow:double-gyre"});
    const auto get = [&](const std::string& query, const std::string& dataset = "rotation") {
        return tests::http(server.port(), "GET",
                           "/api/v1/datasets/" + dataset + "/slice.bin?" + query, server.bearer());
    };
    const std::string plane = "plane=0,0,0:0,0,1&samples=21&field=velocity_y";
    const auto raster = [&](const tests::HttpReply& reply) {
        EXPECT_EQ(reply.status, 200) << reply.body;
        return value_of(protocol::read_slice_file(std::as_bytes(std::span(reply.body)))).raster;
    };
    const core::SliceRaster less = raster(get(plane + "&minus=rotation-2"));
    const core::SliceRaster none = raster(get(plane + "&minus=rotation"));
    for (std::size_t column = 0; column < less.columns; ++column) {
        EXPECT_NEAR(less.values[column], 1.5 * less.place(column, 0).x, 1e-3);
        EXPECT_EQ(none.values[column], 0.0F);
    }
    const std::string gyre = "plane=1,0.5,0.05:0,0,1&samples=8&time=3";
    const core::SliceRaster later = raster(get(gyre + "&minusTime=1", "double-gyre"));
    const core::SliceRaster at_3 = raster(get(gyre, "double-gyre"));
    const core::SliceRaster at_1 =
        raster(get("plane=1,0.5,0.05:0,0,1&samples=8&time=1", "double-gyre"));
    float largest = 0.0F;
    for (std::size_t i = 0; i < later.values.size(); ++i) {
        EXPECT_NEAR(later.values[i], at_3.values[i] - at_1.values[i], 1e-4);
        largest = std::max(largest, std::abs(later.values[i]));
    }
    EXPECT_GT(largest, 0.01F) << "the flow changes";
    // What stands still minus what moves: at the time that is asked for.
    const std::string shared =
        "plane=1,0.5,0.05:0,0,1&samples=8&field=velocity_x&minus=double-gyre";
    EXPECT_EQ(get(shared).status, 400) << "no time";
    EXPECT_EQ(get(shared + "&time=3").status, 200);
    const auto expect = [](const tests::HttpReply& refused, int status, const char* words) {
        EXPECT_EQ(refused.status, status) << refused.body;
        EXPECT_NE(refused.body.find(words), std::string::npos) << refused.body;
    };
    expect(get(plane + "&minus=none"), 404, "there is no dataset of this name");
    expect(get(plane + "&minusTime=x"), 400, "`minusTime` is not a finite number");
}

} // namespace wakesurf::server::slice_downloads_test
