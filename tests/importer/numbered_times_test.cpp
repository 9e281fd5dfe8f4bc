// Times of numbered files that state none: --dt and --start, in the importer and in the commands that start it. The files are
// VTK's writer's.
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/known_flow.hpp"

namespace wakesurf::importer::numbered_times_test {
namespace {

using Times = std::vector<double>;

class NumberedTimes : public Import {
  protected:
    void write_image(const std::string& name, int step, std::optional<double> time = {}) const {
        auto image = sample_image();
        put_known_flow(*image, step);
        write_timed_image(*image, folder_ / name, time);
    }

    void SetUp() override {
        for (int step = 0; step < 4; ++step)
            write_image("s_" + std::to_string(100 * step) + ".vti", step);
    }

    Outcome command(std::vector<std::string> words) const {
        Outcome out;
        const auto done =
            run_child(server_program(), words, 0,
                      [&](std::string_view line) { out.lines.emplace_back(line); }, {});
        out.status = done->exit_status;
        out.errors = done->errors;
        return out;
    }
};

TEST_F(NumberedTimes, CountFromStartByDtAndAreConvertedAnewWhenTheseChange) {
    ASSERT_EQ(run("s_0.vti", {"--dt", "0.5", "--start", "-3"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Times{-3.0, -2.5, -2.0, -1.5}));
    EXPECT_NE(manifest().info.note.find("-3 and then every 0.5, by --start and --dt"),
              std::string::npos)
        << manifest().info.note;
    EXPECT_NE(run("s_0.vti", {"--dt=0.5", "--start=-3"}).lines.back().find("up to date"),
              std::string::npos);
    const auto again = run("s_0.vti", {"--dt=0.25", "--start=-3"});
    EXPECT_EQ(again.lines.size(), 5u) << "four time-steps and the end";
    EXPECT_EQ(manifest().layout.times, (Times{-3.0, -2.75, -2.5, -2.25}));
    ASSERT_EQ(run("s_0.vti", {"--start", "7"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Times{7.0, 8.0, 9.0, 10.0}));
    ASSERT_EQ(run("s_0.vti").status, 0);
    EXPECT_EQ(manifest().layout.times, (Times{0.0, 1.0, 2.0, 3.0}));
}

TEST_F(NumberedTimes, AreLeftOutWhereNumbersOfFilesAreMissing) {
    fs::remove(folder_ / "s_100.vti");
    ASSERT_EQ(run("s_0.vti", {"--dt", "0.5", "--times", "0:1"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Times{0.0, 1.0}));
    write_image("s_500.vti", 5);
    ASSERT_EQ(run("s_0.vti", {"--dt", "0.5"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Times{0.0, 1.0, 1.5, 2.5}));
    EXPECT_NE(manifest().info.note.find("where numbers of files are missing"), std::string::npos)
        << manifest().info.note;
}

TEST_F(NumberedTimes, AreRefusedWhereTheFilesStateTheirOwn) {
    for (int step = 0; step < 2; ++step)
        write_image("t_" + std::to_string(step) + ".vti", step, 2.5 + step);
    for (const char* const option : {"--dt=2", "--start=2"}) {
        const auto outcome = run("t_0.vti", {option});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.errors.find("is for numbered files that state no times; t has the "
                                      "times 2.5 to 3.5"),
                  std::string::npos)
            << outcome.errors;
    }
    for (const char* const wrong : {"--dt=0", "--dt=-1", "--dt=nan", "--start=x", "--start=inf"})
        EXPECT_EQ(run("s_0.vti", {wrong}).status, 2) << wrong;
}

TEST_F(NumberedTimes, AreTakenByTheCommandsThatTakeADataset) {
    const std::string file = (folder_ / "s_0.vti").string();
    const auto info = command({"info", file, "--dt", "0.5", "--start", "2"});
    EXPECT_EQ(info.status, 0) << info.errors;
    EXPECT_NE(std::find(info.lines.begin(), info.lines.end(), "  times     4 from 2 to 3.5"),
              info.lines.end());
    const auto imported = command({"import", file, store(), "--dt", "0.5", "--start", "2"});
    EXPECT_EQ(imported.status, 0) << imported.errors;
    EXPECT_EQ(manifest().layout.times, (Times{2.0, 2.5, 3.0, 3.5}));
    const auto surface = command({"surface", file, "--store", folder_ / "cache", "--kind", "path",
                                  "--rake", "-0.5,1,3 -0.5,1.3,3", "--from", "2", "--to", "2.5",
                                  "--dt", "0.5", "--start", "2", "-o", folder_ / "s.vtp"});
    EXPECT_EQ(surface.status, 0) << surface.errors;
    const auto refused = command({"info", store(), "--dt", "0.5"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.errors.find("store is a store"), std::string::npos) << refused.errors;
    const auto served = command({"serve", "flow:abc", "--dt", "0.5", "--listen", "127.0.0.1:0"});
    EXPECT_EQ(served.status, 1);
    EXPECT_NE(served.errors.find("is a built-in flow"), std::string::npos) << served.errors;
}

} // namespace
} // namespace wakesurf::importer::numbered_times_test
