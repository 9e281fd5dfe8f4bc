// The same surface on any machine: what is in memory, and how much of it there may be, decides nothing.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wakesurf::server::any_memory_test {

namespace {

int run(const std::vector<std::string>& arguments) {
    const auto child =
        run_child(tests::server_program(), arguments, 0, [](std::string_view) {}, {});
    EXPECT_TRUE(child) << child.error().message;
    EXPECT_EQ(child->exit_status, 0) << child->errors;
    return child->exit_status;
}

} // namespace

TEST(AnyMemory, MakesTheSameBytesOfEveryKindWhetherTheSeriesFitsOrNot) {
    const tests::TemporaryFolder folder;
    const std::string store = folder / "tornado.store";
    ASSERT_EQ(run({"generate", "tornado", store, "--grid", "64,64,64", "--times", "0:10:17"}), 0);
    const std::vector<std::vector<std::string>> kinds{{"--kind", "stream"},
                                                      {"--kind", "path"},
                                                      {"--kind", "streak"},
                                                      {"--kind", "time", "--sweep", "0,0,0.2"}};
    for (const auto& kind : kinds)
        for (const std::string accuracy : {"fast", "balanced"}) {
            const auto bytes = [&](const std::string& memory) {
                const std::string out = folder / (memory + ".vtp");
                std::vector<std::string> all{
                    "surface",    store,    "--rake",       "0.3,0.5,0.1 0.7,0.5,0.6",
                    "--to",       "6",      "--separation", "0.03",
                    "--accuracy", accuracy, "--memory",     memory,
                    "-o",         out};
                all.insert(all.end(), kind.begin(), kind.end());
                run(all);
                return tests::read_file(out);
            };
            const std::string all_in_memory = bytes("4GiB"); // the series takes 53 MB
            ASSERT_GT(all_in_memory.size(), 10'000u);
            // Two thirds of the series fit. With less than 52 MiB the largest surface does now and then not: what the
            // program itself takes, 16 MiB, is as the allocator has it.
            EXPECT_TRUE(bytes("64MiB") == all_in_memory) << kind[1] << ", " << accuracy;
        }
}

} // namespace wakesurf::server::any_memory_test
