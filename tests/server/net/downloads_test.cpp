// Whole meshes over HTTP, in every format, from the real program.
#include "protocol/lattice.hpp"
#include "protocol/mesh_decoder.hpp"
#include "tests/support/mesh_readers.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <string>

namespace wakesurf::tests {

using nlohmann::json;

namespace {

class DownloadsTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        server_ = new ServerProcess;
        surface_ = make();
    }

    static void TearDownTestSuite() { delete server_; }

    static std::string make(const std::string& surface = {}, double to = 2.0) {
        WebSocketClient client(*server_);
        const json rake = client.result(
            "rake.set", {{"kind", "line"}, {"points", {{0.2, 0, -1}, {1, 0, -1}}}, {"seeds", 9}});
        json parameters{{"rake", rake["rake"]},
                        {"kind", "stream"},
                        {"dataset", "lamb-oseen"},
                        {"from", 0},
                        {"to", to},
                        {"separation", 0.1}};
        if (!surface.empty())
            parameters["surface"] = surface;
        return client.result("surface.set", parameters)["surface"];
    }

    static HttpReply get(const std::string& file, Headers more = {}) {
        Headers headers = server_->bearer();
        headers.insert(headers.end(), more.begin(), more.end());
        return http(server_->port(), "GET",
                    "/api/v1/sessions/main/surfaces/" + surface_ + "/" + file, headers);
    }

    static ServerProcess* server_;
    static std::string surface_;
};

ServerProcess* DownloadsTest::server_ = nullptr;
std::string DownloadsTest::surface_;

/// The body that the page draws: frames, each behind its length.
protocol::WireMesh decoded(const std::string& body) {
    protocol::MeshDecoder decoder;
    for (std::size_t at = 0; at + 4 <= body.size();) {
        std::uint32_t length = 0;
        std::memcpy(&length, body.data() + at, sizeof length);
        const auto frame = std::as_bytes(std::span(body)).subspan(at + 4, length);
        EXPECT_TRUE(decoder.fold(frame));
        at += 4 + length;
    }
    return decoder.newest() ? *decoder.newest()->mesh : protocol::WireMesh{};
}

} // namespace

TEST_F(DownloadsTest, GiveEveryFormatItsTypeAndItsName) {
    const std::vector<std::pair<std::string, std::string>> types{
        {"vtp", "application/vnd.vtk.polydata+xml"},
        {"glb", "model/gltf-binary"},
        {"ply", "application/x-ply"},
        {"obj", "model/obj"},
        {"drc", "application/octet-stream"}};
    for (const auto& [extension, type] : types) {
        const HttpReply reply = get("mesh." + extension);
        EXPECT_EQ(reply.status, 200) << extension << reply.body.substr(0, 200);
        EXPECT_EQ(reply.header("content-type"), type);
        EXPECT_EQ(reply.header("content-disposition"),
                  "attachment; filename=\"" + surface_ + "." + extension + "\"");
        EXPECT_EQ(reply.header("content-length"), std::to_string(reply.body.size()));
    }
}

TEST_F(DownloadsTest, AreOneMeshWhateverTheFormat) {
    const auto ply = read_ply(get("mesh.ply").body);
    const auto obj = read_obj(get("mesh.obj").body);
    const auto glb = read_glb(get("mesh.glb").body);
    const auto drc = read_drc(get("mesh.drc").body);
    ASSERT_GT(ply.points.size(), 100u);
    EXPECT_EQ(obj.points, ply.points);
    EXPECT_EQ(glb.points, drc.points);
    EXPECT_EQ(glb.points.size(), ply.points.size());
    EXPECT_EQ(ply.about.at("dataset"), "lamb-oseen");
}

TEST_F(DownloadsTest, AreNotSentAgainToWhoHasThem) {
    for (const std::string file : {"mesh.vtp", "mesh.glb", "mesh.ply", "mesh.obj", "mesh.drc"}) {
        const std::string tag = get(file).header("etag");
        ASSERT_FALSE(tag.empty());
        for (const std::string& match : {tag, "W/" + tag, "\"other\", " + tag, std::string("*")})
            EXPECT_EQ(get(file, {{"If-None-Match", match}}).status, 304) << file << " " << match;
        EXPECT_EQ(get(file, {{"If-None-Match", "\"other\""}}).status, 200);
    }
}

TEST_F(DownloadsTest, ChangeTheirTagWithTheSurface) {
    const std::string before = get("mesh.ply").header("etag");
    make(surface_, 3.0);
    const HttpReply after = get("mesh.ply", {{"If-None-Match", before}});
    EXPECT_EQ(after.status, 200);
    EXPECT_NE(after.header("etag"), before);
}

TEST_F(DownloadsTest, OfFilesThereAreNotAre404AndSayWhichThereAre) {
    for (const std::string file :
         {"mesh.stl", "mesh", "mesh.", "mesh.PLY", "other.ply", "mesh.ply.vtp"}) {
        const HttpReply reply = get(file);
        EXPECT_EQ(reply.status, 404) << file;
        EXPECT_NE(reply.body.find(".vtp, .glb, .ply, .obj or .drc"), std::string::npos)
            << reply.body;
    }
}

TEST(ObstacleDownload, OfABuiltInFlowIsTheBodyThatItIsSolidIn) {
    const ServerProcess server({"flow:sphere?a=2", "flow:tornado"});
    const auto obstacle = [&](const std::string& dataset) {
        return http(server.port(), "GET", "/api/v1/datasets/" + dataset + "/obstacle.bin",
                    server.bearer());
    };
    const HttpReply reply = obstacle("sphere");
    ASSERT_EQ(reply.status, 200) << reply.body;
    const protocol::WireMesh mesh = decoded(reply.body);
    const auto lattice = protocol::lattice_over({core::Vec3(-5), core::Vec3(10, 5, 5)});
    ASSERT_GT(mesh.vertices(), 1000u);
    EXPECT_GT(mesh.cells().size(), 2000u);
    for (const protocol::LatticePoint& node : mesh.position)
        EXPECT_NEAR(glm::length(protocol::dequantise(lattice, node)), 2.0, lattice.step);
    EXPECT_EQ(obstacle("tornado").status, 404);
}

} // namespace wakesurf::tests
