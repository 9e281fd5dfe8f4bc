#include "server/net/download_request.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::download_request_test {

namespace {

using Code = core::Error::Code;

core::SurfaceParameters path(double to = 14.0) {
    return {.kind = core::SurfaceKind::Path, .from = 10.0, .to = to};
}

std::optional<double> shown(const std::map<std::string, std::string>& query,
                            const core::SurfaceParameters& p,
                            std::optional<double> clock) {
    return shown_at(read_download("mesh.vtp", query).value(), p, clock).value();
}

} // namespace

TEST(DownloadRequest, KnowsEveryFormatAndNoOtherFile) {
    EXPECT_EQ(read_download("mesh.glb", {}).value().format, protocol::MeshFormat::Glb);
    for (const std::string file : {"mesh.stl", "mesh", "other.vtp", "mesh.VTP"})
        EXPECT_EQ(read_download(file, {}).error().code, Code::NotFound) << file;
}

TEST(DownloadRequest, RefusesAQueryItDoesNotKnowAndNamesIt) {
    for (const auto& [name, value] :
         std::map<std::string, std::string>{{"draco", "no"}, {"tme", "1"}, {"time", "NaN"}}) {
        const auto read = read_download("mesh.glb", {{name, value}});
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, Code::InvalidArgument);
        EXPECT_NE(read.error().message.find("`" + name + "`"), std::string::npos);
        EXPECT_FALSE(read.error().hint.empty());
    }
    for (const std::string time : {"", "inf", "-inf", "1e999", "1 ", "0x10", "END"})
        EXPECT_FALSE(read_download("mesh.vtp", {{"time", time}})) << time;
    EXPECT_FALSE(read_download("mesh.drc", {{"draco", "false"}}));
    EXPECT_TRUE(read_download("mesh.ply", {{"draco", "false"}}));
}

TEST(DownloadRequest, FollowsTheClockWithinWhatTheSurfaceIsShownOver) {
    EXPECT_EQ(shown({}, path(), std::nullopt), std::nullopt) << "a clock never set: the end";
    EXPECT_EQ(shown({}, path(), 11.5), 11.5);
    EXPECT_EQ(shown({}, path(), 3.0), 10.0);
    EXPECT_EQ(shown({}, path(), 99.0), 14.0);
    EXPECT_EQ(shown({}, path(6.0), 8.0), 8.0);
    EXPECT_EQ(shown({}, path(6.0), 12.0), 10.0);
}

TEST(DownloadRequest, PutsATimeThatIsNamedBeforeTheClock) {
    EXPECT_EQ(shown({{"time", "12.25"}}, path(), 11.5), 12.25);
    EXPECT_EQ(shown({{"time", "end"}}, path(), 11.5), std::nullopt);
    const auto outside =
        shown_at(read_download("mesh.vtp", {{"time", "15"}}).value(), path(), std::nullopt);
    ASSERT_FALSE(outside);
    EXPECT_EQ(outside.error().code, Code::OutOfTime);
    EXPECT_NE(outside.error().message.find("10 to 14"), std::string::npos);
}

TEST(DownloadRequest, HasNoTimeWhereTheSurfaceDoesNotMove) {
    core::SurfaceParameters stream = path();
    stream.kind = core::SurfaceKind::Stream;
    EXPECT_EQ(shown({}, stream, 11.5), std::nullopt);
    EXPECT_EQ(shown({{"time", "99"}}, stream, 11.5), std::nullopt);
}

TEST(DownloadRequest, TakesLinesOnlyInFormatsThatHaveThem) {
    EXPECT_EQ(read_download("mesh.vtp", {{"lines", "timelines:8"}})->lines, "timelines:8");
    for (const char* file : {"mesh.obj", "mesh.ply", "mesh.glb"})
        EXPECT_TRUE(read_download(file, {{"lines", "timelines:8"}})) << file;
    EXPECT_FALSE(read_download("mesh.vtp", {{"lines", ""}}));
    EXPECT_EQ(read_download("mesh.vtp", {{"tessellate", "4"}})->tessellate, 4u);
    for (const char* wrong : {"", "0", "65", "-1", "4.5", "4x", "99999999999"})
        EXPECT_EQ(read_download("mesh.vtp", {{"tessellate", wrong}}).error().message,
                  "`tessellate` is not a whole number from 1 to 64")
            << wrong;
}

} // namespace wakesurf::server::download_request_test
