// A surface over a series whose last file is still being written, in a session that is open.
#include "tests/support/server/server_process.hpp"
#include "tests/support/server/websocket_client.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vti_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::tests::growing_data_test {

using nlohmann::json;

namespace {

/// 3 x 4 x 5 nodes, flowing along z.
std::string uniform_flow() {
    VtiText image;
    image.points = vti_array("U", 3, image.point_count(),
                             [](std::size_t i) { return i % 3 == 2 ? 1.0 : 0.0; });
    return image.text();
}

} // namespace

TEST(GrowingData, ASurfaceThatEndedForWantOfATimeStepIsBuiltAgainOnceItIsThere) {
    const TemporaryFolder folder;
    const std::string whole = uniform_flow();
    write_file(folder / "u_0.vti", whole);
    write_file(folder / "u_1.vti", whole);
    write_file(folder / "u_2.vti", whole.substr(0, 200));
    ServerProcess server({folder / "u_0.vti", "--store", folder / "store"});
    WebSocketClient client(server);
    const auto failed = [&] {
        const json entry = client.result("dataset.list")["datasets"][0];
        return entry["state"] == "incomplete" && entry.contains("error");
    };
    while (!failed())
        client.notification("dataset.patched");
    const json rake = client.result(
        "rake.set", {{"kind", "line"}, {"points", {{0.5, 1, 0.5}, {1.5, 1, 0.5}}}, {"seeds", 4}});
    const json set = client.result(
        "surface.set",
        {{"rake", rake["rake"]}, {"kind", "path"}, {"dataset", "u_0"}, {"from", 0}, {"to", 2}});
    json done = client.notification("surface.done");
    ASSERT_TRUE(done["stats"].contains("stopped")) << done;
    EXPECT_EQ(done["epoch"], set["epoch"]);
    const auto before = done["stats"]["quads"].get<int>();
    write_file(folder / "u_2.vti", whole);
    done = client.notification("surface.done"); // no one asked for it
    EXPECT_FALSE(done["stats"].contains("stopped")) << done;
    EXPECT_GT(done["epoch"].get<int>(), set["epoch"].get<int>());
    EXPECT_GT(done["stats"]["quads"].get<int>(), before);
}

} // namespace wakesurf::tests::growing_data_test
