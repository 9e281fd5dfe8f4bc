// Whole meshes over HTTP, in every format, from the real program.
#include "protocol/wire/lattice.hpp"
#include "protocol/wire/mesh_decoder.hpp"
#include "server/data/child_process.hpp"
#include "store/store_generation.hpp"
#include "tests/support/dequantise.hpp"
#include "tests/support/mesh_readers.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <tuple>

namespace wakesurf::tests::downloads_test {

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
        return get_of(surface_, file, std::move(more));
    }

    static HttpReply
    get_of(const std::string& surface, const std::string& file, Headers more = {}) {
        Headers headers = server_->bearer();
        headers.insert(headers.end(), more.begin(), more.end());
        return http(server_->port(), "GET",
                    "/api/v1/sessions/main/surfaces/" + surface + "/" + file, headers);
    }

    /// A path surface from 0 to 2.
    static std::string make_moving(WebSocketClient& client) {
        return make_in(client, "main", "lamb-oseen", 0.1, "path");
    }

    static std::string make_in(WebSocketClient& client,
                               const std::string& session,
                               const std::string& dataset,
                               double separation,
                               const std::string& kind = "stream",
                               double to = 2.0) {
        const json rake = client.result("rake.set", {{"session", session},
                                                     {"kind", "line"},
                                                     {"points", {{0.2, 0, -1}, {1, 0, -1}}},
                                                     {"seeds", 9}});
        return client.result("surface.set", {{"session", session},
                                             {"rake", rake["rake"]},
                                             {"kind", kind},
                                             {"dataset", dataset},
                                             {"from", 0},
                                             {"to", to},
                                             {"maxQuads", 4'000'000},
                                             {"separation", separation}})["surface"];
    }

    /// Of the flow abc: shown as it is just after its release, which is nothing to compute; later it is much.
    static std::string slow_to_download(WebSocketClient& client, const std::string& session) {
        client.result("time.set", {{"session", session}, {"time", 0.0}});
        const std::string surface = make_in(client, session, "abc", 0.002, "streak", 500.0);
        client.result("surface.wait",
                      {{"session", session}, {"surface", surface}, {"timeoutMs", 60000}});
        return surface;
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

TEST_F(DownloadsTest, AreMadeAgainFromTheirRecipesByTheProgram) {
    WebSocketClient client(*server_);
    const std::string moving = make_moving(client);
    const TemporaryFolder folder;
    int count = 0;
    const auto verified = [&](const std::string& surface, const std::string& file) {
        const std::size_t dot = file.find('.');
        const auto name =
            folder / (std::to_string(++count) + file.substr(dot, file.find('?') - dot));
        std::ofstream(name, std::ios::binary) << get_of(surface, file).body;
        const auto outcome = server::run_child(server_program(), {"verify", name.string()}, 0,
                                               [](std::string_view) {}, {});
        EXPECT_EQ(outcome->exit_status, 0) << surface << " " << file << outcome->errors;
    };
    for (const char* file : {"mesh.vtp", "mesh.glb?draco=false", "mesh.ply?tessellate=2",
                             "mesh.obj", "mesh.drc", "mesh.vtp?lines=timelines:4"})
        verified(surface_, file);
    for (const char* file : {"mesh.vtp?time=0.7", "mesh.ply?time=end", "mesh.ply?now=true"})
        verified(moving, file);
    if (get_of(moving, "animation.html?times=0:2:1").status == 404)
        GTEST_SKIP() << "without the built web client";
    for (const char* file : {"animation.html?times=0:1.5:0.5",
                             "animation.html?times=0:2:0.5&look=%7B%22map%22:%22grey%22%7D"})
        verified(moving, file);
}

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

TEST_F(DownloadsTest, AreAsTheSessionShowsThemAtTheTimeOfItsClock) {
    WebSocketClient client(*server_);
    const std::string path = make_moving(client);
    const auto ply = [&](const std::string& query) {
        const HttpReply reply = get_of(path, "mesh.ply" + query);
        EXPECT_EQ(reply.status, 200) << reply.body.substr(0, 300);
        return reply;
    };
    const auto end = ply("");
    EXPECT_EQ(read_ply(end.body).about.count("time"), 0u);
    client.result("time.set", {{"time", 1.0}});
    const auto then = ply("");
    EXPECT_EQ(read_ply(then.body).about.at("time"), "1");
    EXPECT_NE(then.header("etag"), end.header("etag"));
    EXPECT_EQ(get_of(path, "mesh.ply", {{"If-None-Match", end.header("etag")}}).status, 200);
    const json stats = client.result("surface.wait", {{"surface", path}, {"timeoutMs", 60000}});
    EXPECT_EQ(read_ply(then.body).points.size(), stats["vertices"]) << "what the page shows";
    EXPECT_LT(read_ply(then.body).points.size(), read_ply(end.body).points.size());
    EXPECT_EQ(ply("?time=end").body, end.body);
    EXPECT_EQ(ply("?time=1").body, then.body);
    client.result("time.set", {{"time", nullptr}});
    EXPECT_EQ(ply("").body, end.body);
    EXPECT_EQ(ply("?time=1").header("etag"), then.header("etag"));
}

TEST_F(DownloadsTest, GiveWhatIsShownWhileTheFinalSurfaceIsLongInComingAndSaySo) {
    WebSocketClient client(*server_);
    // Millions of quads, which take minutes; what is shown meanwhile is there at once.
    const std::string surface = make_in(client, "main", "lamb-oseen", 0.002, "streak", 20.0);
    json stats;
    for (int asked = 0; asked < 240 && !(stats.is_object() && stats["quads"] > 0); ++asked) {
        (void)client.call("surface.wait", {{"surface", surface}, {"timeoutMs", 250}});
        stats = client.result("surface.stats", {{"surface", surface}});
    }
    ASSERT_GT(stats["quads"], 0);
    ASSERT_FALSE(stats["complete"]);
    client.result("surface.stop", {{"surface", surface}});
    stats = client.result("surface.stats", {{"surface", surface}});
    EXPECT_NE(get_of(surface, "mesh.ply").status, 200) << "it was stopped";
    const HttpReply reply = get_of(surface, "mesh.ply?now=true");
    ASSERT_EQ(reply.status, 200) << reply.body.substr(0, 300);
    EXPECT_EQ(reply.header("content-disposition"),
              "attachment; filename=\"" + surface + "-coarse.ply\"");
    const auto ply = read_ply(reply.body);
    EXPECT_EQ(ply.points.size(), stats["vertices"]) << "what the page shows";
    EXPECT_NE(ply.about.at("stopped").find("coarse"), std::string::npos);
    // Under a sanitizer on a busy machine the files take so long that a client that reads nothing meanwhile is gone.
    WebSocketClient(*server_).result("surface.delete", {{"surface", surface}});

    const HttpReply whole = get("mesh.ply?now=true");
    EXPECT_EQ(whole.body, get("mesh.ply").body) << "it is final";
    EXPECT_EQ(whole.header("content-disposition").find("coarse"), std::string::npos);
}

TEST_F(DownloadsTest, SayWhatIsWrongWithTheirQuery) {
    WebSocketClient client(*server_);
    const std::string path = make_moving(client);
    for (const auto& [query, code, word] : std::vector<std::tuple<std::string, int, std::string>>{
             {"?time=NaN", -32602, "`time`"},
             {"?time=7", -32013, "0 to 2"},
             {"?draco=maybe", -32602, "`draco`"},
             {"?now=soon", -32602, "`now`"},
             {"?when=1", -32602, "`when`"},
             {"?time", -32602, "query"},
             {"?time=1&time=2", -32602, "query"}}) {
        const HttpReply reply = get_of(path, "mesh.glb" + query);
        EXPECT_EQ(reply.status, 400) << query;
        const json error = json::parse(reply.body)["error"];
        EXPECT_EQ(error["code"], code) << query;
        EXPECT_NE(error["message"].get<std::string>().find(word), std::string::npos) << error;
        EXPECT_FALSE(error["data"]["hint"].get<std::string>().empty());
    }
}

TEST_F(DownloadsTest, GiveAGlbWithoutDracoToWhoAsks) {
    const auto plain = read_glb(get("mesh.glb?draco=false").body);
    EXPECT_EQ(json::parse(plain.json).count("extensionsRequired"), 0u);
    EXPECT_TRUE(plain.arrays.contains("_SPEED"));
    EXPECT_EQ(plain.points.size(), read_glb(get("mesh.glb").body).points.size());
    EXPECT_NE(get("mesh.glb?draco=false").header("etag"), get("mesh.glb").header("etag"));
}

TEST_F(DownloadsTest, OfOneLinkNeverKeepAnotherSessionsWaiting) {
    const ServerProcess server({"flow:abc", "flow:lamb-oseen"});
    WebSocketClient host(server, {});
    const std::string theirs = host.result("session.create", {{"name", "theirs"}})["session"];
    const std::string surface = slow_to_download(host, theirs);
    const std::string key =
        host.result("session.share", {{"session", theirs}, {"role", "viewer"}})["key"];
    std::vector<RawSocket> guests;
    for (int i = 1; i <= 16; ++i) {
        guests.emplace_back(server.port());
        guests.back().send(
            fmt::format("GET /api/v1/sessions/{}/surfaces/{}/mesh.ply?time={} HTTP/1.1\r\n"
                        "Host: 127.0.0.1:{}\r\nAuthorization: Bearer {}\r\n\r\n",
                        theirs, surface, 100 + i, server.port(), key));
    }
    const std::string mine = make_in(host, "main", "lamb-oseen", 0.1);
    for (int i = 0; i < 20; ++i) {
        const HttpReply reply = http(server.port(), "GET",
                                     fmt::format("/api/v1/sessions/main/surfaces/{}/mesh.{}", mine,
                                                 i % 2 == 0 ? "ply" : "obj"),
                                     server.bearer());
        EXPECT_EQ(reply.status, 200) << reply.body.substr(0, 200);
    }
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
        EXPECT_NEAR(glm::length(dequantise(lattice, node)), 2.0, lattice.step);
    EXPECT_EQ(obstacle("tornado").status, 404);
    const auto with = [&](const std::string& query) {
        return http(server.port(), "GET", "/api/v1/datasets/sphere/obstacle.bin?" + query,
                    server.bearer());
    };
    EXPECT_EQ(decoded(with("patches=all").body).position, mesh.position);
    EXPECT_EQ(with("patches=inlet").status, 400);
}

TEST(ObstacleDownload, AtATimeHasTheVelocityOffTheBody) {
    const TemporaryFolder folder;
    store::GenerateRequest ball;
    ball.flow = "sphere?a=2";
    ball.grid = {{-4, -4, -4}, {0.25, 0.25, 0.25}, {33, 33, 33}};
    ball.times = {0.0, 2.0};
    ASSERT_TRUE(
        store::generate_store(ball, folder / "ball", [](const store::ImportProgress&) {}, {}));
    const ServerProcess server({"flow:sphere?a=2", "flow:tornado", folder / "ball"});
    server.rpc(R"({"jsonrpc":"2.0","id":1,"method":"dataset.open","params":{"dataset":"ball"}})");
    const auto at = [&](const std::string& dataset, const std::string& query) {
        return http(server.port(), "GET", "/api/v1/datasets/" + dataset + "/obstacle.bin" + query,
                    server.bearer());
    };
    for (const std::string dataset : {"sphere", "ball"}) {
        const HttpReply reply = at(dataset, "?time=1.5");
        ASSERT_EQ(reply.status, 200) << reply.body;
        const protocol::WireMesh mesh = decoded(reply.body);
        EXPECT_EQ(mesh.position, decoded(at(dataset, "").body).position);
        ASSERT_EQ(mesh.codes.size(), 6u); // speed, s, t, and the velocity
        std::size_t forward = 0;
        for (std::size_t i = 0; i < mesh.vertices(); ++i)
            forward += mesh.ranges[3].value(mesh.codes[3][i]) > 0.0 ? 1 : 0;
        EXPECT_GT(forward, mesh.vertices() * 9 / 10) << dataset;
        EXPECT_EQ(at(dataset, "?time=soon").status, 400);
        EXPECT_NE(at(dataset, "?field=vorticity").body.find("needs a `time`"), std::string::npos);
        EXPECT_NE(at(dataset, "?step=1").body.find("no parameter `step`"), std::string::npos);
    }
    EXPECT_EQ(at("sphere", "?time=7").body, at("sphere", "?time=1.5").body) << "it stands still";
    const HttpReply late = at("ball", "?time=2.5");
    EXPECT_EQ(late.status, 400);
    EXPECT_NE(late.body.find("time 2.5 is outside the data's 0 to 2"), std::string::npos)
        << late.body;
    EXPECT_EQ(at("tornado", "?time=0").status, 404);
}

TEST(ObstacleDownload, HasAFieldBesideTheBody) {
    const ServerProcess server({"flow:sphere?a=2"});
    const auto at = [&](const std::string& query) {
        return http(server.port(), "GET", "/api/v1/datasets/sphere/obstacle.bin" + query,
                    server.bearer());
    };
    const HttpReply reply = at("?time=1.5&field=velocity");
    ASSERT_EQ(reply.status, 200) << reply.body;
    const protocol::WireMesh mesh = decoded(reply.body);
    ASSERT_EQ(mesh.codes.size(), 7U);
    const auto lattice = protocol::lattice_over({core::Vec3(-5), core::Vec3(10, 5, 5)});
    for (std::size_t i = 0; i < mesh.vertices();
         i += 50) { // potential flow: 3/2 sin(theta) U on the sphere
        const core::Vec3 p = dequantise(lattice, mesh.position[i]) / 2.0;
        EXPECT_NEAR(mesh.ranges[6].value(mesh.codes[6][i]), 1.5 * std::hypot(p.y, p.z), 0.05);
    }
    EXPECT_EQ(at("?time=1.5&field=nothing").status, 404);
    const HttpReply of_surfaces = at("?time=1.5&field=error");
    EXPECT_EQ(of_surfaces.status, 404);
    EXPECT_NE(of_surfaces.body.find("a field of surfaces"), std::string::npos) << of_surfaces.body;
}

} // namespace wakesurf::tests::downloads_test
