// One stored period that is repeated: --loop.
#include "tests/importer/import_fixture.hpp"

namespace wakesurf::importer::repeated_period_test {
namespace {

class RepeatedPeriod : public Import {
  protected:
    // A series of uniform flows; its speed at each time.
    void put_series(const std::vector<std::pair<double, int>>& speeds) const {
        std::vector<std::pair<std::string, std::string>> entries;
        for (const auto& [time, speed] : speeds) {
            const std::string name = "s" + std::to_string(entries.size()) + ".vti";
            put(name, sample_vti(speed).text());
            entries.emplace_back(std::to_string(time), name);
        }
        put("s.pvd", pvd_text(entries));
    }

    std::vector<double> speeds() const {
        std::vector<double> out;
        for (std::size_t i = 0; i < manifest().layout.times.size(); ++i)
            out.push_back(velocity(i)[0]);
        return out;
    }

    bool told(const std::string& words) const {
        return manifest().info.note.find(words) != std::string::npos;
    }
};

using Numbers = std::vector<double>;

TEST_F(RepeatedPeriod, TakesALastTimeStepThatIsTheFirstAgainForIt) {
    put_series({{0, 1}, {1, 3}, {1.5, 2}, {2, 1}});
    ASSERT_EQ(run("s.pvd", {"--loop", "3"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Numbers{0, 1, 1.5, 2, 3, 3.5, 4, 5, 5.5, 6}));
    EXPECT_EQ(speeds(), (Numbers{1, 3, 2, 1, 3, 2, 1, 3, 2, 1}));
    EXPECT_TRUE(told("the times 0 to 2 are one period of 2, repeated 3 times by --loop: the last "
                     "time-step is the first again"))
        << manifest().info.note;
}

TEST_F(RepeatedPeriod, GoesOnFromTheLastTimeStepToTheFirstWhereTheyDiffer) {
    put_series({{0, 1}, {1, 2}, {3, 3}});
    ASSERT_EQ(run("s.pvd", {"--loop", "2"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Numbers{0, 1, 3, 5, 6, 8, 10}));
    EXPECT_EQ(speeds(), (Numbers{1, 2, 3, 1, 2, 3, 1}));
    EXPECT_TRUE(told("one period of 5")) << manifest().info.note;
}

TEST_F(RepeatedPeriod, IsAsLongAsItIsStatedToBe) {
    put_series({{0, 1}, {1, 2}, {3, 3}});
    ASSERT_EQ(run("s.pvd", {"--loop", "2:4"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Numbers{0, 1, 3, 4, 5, 7, 8}));
    ASSERT_EQ(run("s.pvd", {"--loop", "2:3"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (Numbers{0, 1, 3, 4, 6}));
    EXPECT_EQ(speeds(), (Numbers{1, 2, 1, 2, 1}));
}

TEST_F(RepeatedPeriod, TakesNoMoreRoomThanOnce) {
    put_series({{0, 1}, {1, 3}, {2, 2}});
    for (const char* layout : {"whole", "bricks"}) {
        ASSERT_EQ(run("s.pvd", {"--loop", "10", "--layout", layout}).status, 0);
        std::size_t files = 0;
        for (const auto& entry : fs::directory_iterator(store()))
            if (entry.path().filename().string().starts_with("velocity_000000"))
                EXPECT_EQ(fs::hard_link_count(entry.path()), 11u) << layout << ++files;
        EXPECT_EQ(speeds()[17], 2.0) << layout;
    }
}

TEST_F(RepeatedPeriod, IsImportedOnceAndGoesOnWhereItWasInterrupted) {
    put_series({{0, 1}, {1, 3}, {2, 2}});
    ASSERT_EQ(run("s.pvd", {"--loop", "4"}).status, 0);
    EXPECT_EQ(run("s.pvd", {"--loop", "4"}).lines.size(), 1u); // up to date
    fs::remove(store() / "velocity_000007.f32");
    ASSERT_EQ(run("s.pvd", {"--loop", "4"}).status, 0);
    EXPECT_EQ(speeds(), (Numbers{1, 3, 2, 1, 3, 2, 1, 3, 2, 1, 3, 2, 1}));
}

TEST_F(RepeatedPeriod, IsRefusedWhereItCannotBeOne) {
    put_series({{0, 1}, {1, 2}, {3, 3}});
    const auto complaint = [&](const char* name, std::vector<std::string> options) {
        const auto outcome = run(name, std::move(options));
        EXPECT_EQ(outcome.status, 2) << outcome.errors;
        return outcome.errors;
    };
    EXPECT_TRUE(complaint("s.pvd", {"--loop", "5:2"})
                    .starts_with("wakesurf-import: --loop: a period of 2 is shorter than the "
                                 "stored times, which go on for 3"));
    EXPECT_TRUE(complaint("s0.vti", {"--loop", "5", "--alone"})
                    .starts_with("wakesurf-import: --loop needs two time-steps or more"));
    put("s2.vti", sample_vti(3).text().substr(0, 400));
    EXPECT_TRUE(complaint("s.pvd", {"--loop", "5"})
                    .starts_with("wakesurf-import: --loop needs a whole period, but the data end "
                                 "before time 3: s2.vti"));
    for (const char* wrong : {"1", "0", "-3", "1001", "2:", "2:0", "2:nan", "2x", ""})
        EXPECT_EQ(run("s.pvd", {"--loop", wrong}).status, 2) << wrong;
}

} // namespace
} // namespace wakesurf::importer::repeated_period_test
