// Stores on a real web server, a distance away.
#include "core/surface/builder/surface_builder.hpp"
#include "server/data/child_process.hpp"
#include "server/data/open_dataset.hpp"
#include "server/remote/remote_dataset.hpp"
#include "tests/server/data/catalogue_bench.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/nginx.hpp"
#include "tests/support/server/scripted_web_server.hpp"
#include "tests/support/server/server_process.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace wakesurf::server::web_store_test {

namespace {

/// A tornado in 2 x 2 x 2 bricks of 32 cells and 5 time-steps.
void generate(const std::filesystem::path& store, const std::string& layout) {
    const auto made = run_child(tests::server_program(),
                                {"generate", "tornado", store.string(), "--grid", "50,50,50",
                                 "--times", "0:1:5", "--layout", layout},
                                0, [](std::string_view) {}, {});
    ASSERT_TRUE(made);
    ASSERT_EQ(made->exit_status, 0) << made->errors;
}

core::Result<core::Surface> surface(const LoadedDataset& dataset, core::SurfaceKind kind) {
    core::SurfaceParameters parameters;
    parameters.kind = kind;
    parameters.to = 1.0;
    if (kind == core::SurfaceKind::Time)
        parameters.sweep = core::Vec3{0.0, 0.1, 0.0};
    parameters.separation = 0.03;
    const core::Rake rake{core::Rake::Kind::Line, {{0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}}, 8};
    return core::build_surface(*dataset.flow, rake, parameters);
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string out(values.size() * sizeof(T), '\0');
    if (!values.empty())
        std::memcpy(out.data(), values.data(), out.size());
    return out;
}

class WebStoreTest : public testing::Test {
  protected:
    void SetUp() override { generate(folder_ / "wake", "bricks"); }

    std::string address(std::uint16_t port) const {
        return "http://127.0.0.1:" + std::to_string(port) + "/wake";
    }

    tests::TemporaryFolder folder_;
};

} // namespace

TEST_F(WebStoreTest, SurfacesFromFarAwayHaveTheBytesOfThoseFromFiles) {
    const tests::Nginx nginx(folder_.path());
    const auto near = open_store(folder_ / "wake", {});
    const auto far = open_store(address(nginx.port()), {});
    ASSERT_TRUE(near) << near.error().message;
    ASSERT_TRUE(far) << far.error().message;
    ASSERT_NE(far->cache->bricks(), nullptr) << "bricks are asked for as they are wanted";
    for (const auto kind : {core::SurfaceKind::Stream, core::SurfaceKind::Path,
                            core::SurfaceKind::Streak, core::SurfaceKind::Time}) {
        const auto a = surface(*near, kind);
        const auto b = surface(*far, kind);
        ASSERT_TRUE(a) << a.error().message;
        ASSERT_TRUE(b) << b.error().message;
        EXPECT_GT(a->mesh.cells.size(), 20u);
        EXPECT_EQ(bytes_of(a->mesh.position), bytes_of(b->mesh.position));
        EXPECT_EQ(bytes_of(a->mesh.velocity), bytes_of(b->mesh.velocity));
        EXPECT_EQ(a->mesh.cells, b->mesh.cells);
    }
}

TEST_F(WebStoreTest, WholeTimeStepsAreReadFromThereAsWell) {
    generate(folder_ / "whole", "whole");
    const tests::Nginx nginx(folder_.path());
    const std::string root = "http://127.0.0.1:" + std::to_string(nginx.port());
    const auto whole = open_store(root + "/whole", {});
    ASSERT_TRUE(whole) << whole.error().message;
    const auto bricks = open_store(root + "/wake", {});
    const auto a = surface(*whole, core::SurfaceKind::Streak);
    const auto b = surface(*bricks, core::SurfaceKind::Streak);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(bytes_of(a->mesh.position), bytes_of(b->mesh.position));
}

TEST_F(WebStoreTest, TheCommandLineTakesAnAddressForAFolder) {
    const tests::Nginx nginx(folder_.path());
    std::string said;
    const auto run = [&](std::vector<std::string> arguments) {
        const auto line = [&](std::string_view text) { said.append(text).append("\n"); };
        return run_child(tests::server_program(), arguments, 0, line, {}).value();
    };
    const auto info = run({"info", address(nginx.port())});
    EXPECT_EQ(info.exit_status, 0) << info.errors;
    EXPECT_NE(said.find("brick by brick: the store is on the web"), std::string::npos) << said;
    std::vector<std::string> files;
    for (const std::string& dataset : {address(nginx.port()), (folder_ / "wake").string()}) {
        const std::string file = (folder_ / "out.ply").string();
        const auto made = run({"surface", dataset, "--kind", "stream", "--rake",
                               "0.4,0.5,0.1 0.6,0.5,0.8", "--to", "1", "-o", file});
        ASSERT_EQ(made.exit_status, 0) << made.errors;
        files.push_back(tests::read_file(file));
    }
    EXPECT_GT(files[0].size(), 1000u);
    const auto body = [](const std::string& text) { return text.substr(text.find("end_header")); };
    EXPECT_EQ(body(files[0]), body(files[1]));
    const auto none = run({"info", "http://127.0.0.1:" + std::to_string(nginx.port()) + "/none"});
    EXPECT_NE(none.exit_status, 0);
    EXPECT_NE(none.errors.find("/none/store.json is not there"), std::string::npos) << none.errors;
}

TEST_F(WebStoreTest, ASurfaceEndsWhereABrickCannotBeHadAndSaysSo) {
    const tests::Nginx nginx(folder_.path());
    const auto open = open_store(address(nginx.port()), {});
    ASSERT_TRUE(open) << open.error().message;
    ASSERT_TRUE(surface(*open, core::SurfaceKind::Streak));
    std::filesystem::resize_file(folder_ / "wake/velocity_000002.f32", 100);
    const auto again = open_store(address(nginx.port()), {});
    ASSERT_TRUE(again) << again.error().message;
    const auto cut = surface(*again, core::SurfaceKind::Streak);
    ASSERT_TRUE(cut) << cut.error().message;
    const std::string& why = cut->statistics.stopped;
    EXPECT_NE(why.find("of time-step 2 (velocity_000002.f32)"), std::string::npos) << why;
    EXPECT_NE(why.find("velocity_000002.f32 has 100 bytes instead of"), std::string::npos) << why;
}

TEST_F(WebStoreTest, AServerThatSaysNothingKeepsNeitherOtherDatasetsNorTheEndWaiting) {
    const tests::ScriptedWebServer silent([](const std::string&) {
        tests::ScriptedWebServer::Reply reply;
        reply.silent = true;
        return reply;
    });
    std::vector<std::string> datasets;
    for (const char* name : {"a", "b", "c", "d", "e"})
        datasets.push_back(silent.address(name));
    datasets.push_back(folder_ / "wake");
    CatalogueBench bench(datasets);
    ASSERT_TRUE(bench.catalogue) << bench.error->message;
    bench.wait_until(
        "wake", [](const DatasetStatus& status) { return status.state == DatasetState::Ready; });
    bench.catalogue.reset(); // returns
}

TEST(WebStore, NoClientCanHaveTheServerAskAnotherMachine) {
    const tests::ScriptedWebServer web(
        [](const std::string&) { return tests::ScriptedWebServer::Reply{}; });
    const tests::ServerProcess server;
    const std::string answer =
        server.rpc(R"({"jsonrpc":"2.0","id":1,"method":"dataset.open","params":{"dataset":")" +
                   web.address("wake") + R"("}})");
    EXPECT_NE(answer.find("there is no dataset of this name"), std::string::npos) << answer;
    EXPECT_EQ(web.connections(), 0u);
}

} // namespace wakesurf::server::web_store_test
