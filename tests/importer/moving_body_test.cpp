// A body that moves, marked by a scalar: --mask.
#include "tests/importer/import_fixture.hpp"

#include <cmath>
#include <set>

namespace wakesurf::importer::moving_body_test {
namespace {

class MovingBody : public Import {
  protected:
    // A row of 5 cells with a body in cell `time`, marked at its points or in it.
    void put_series(bool marks_points, bool velocity_at_points) const {
        for (int time = 0; time < 3; ++time) {
            VtiText file;
            file.nodes = {6, 2, 2};
            const auto solid = [&](std::size_t i) {
                const std::size_t x = marks_points ? i % 6 : i % 5;
                const auto at = static_cast<std::size_t>(time);
                return x == at || (marks_points && x == at + 1) ? 1.0 : 0.0;
            };
            (marks_points ? file.points : file.cells) += vti_array(
                "solid", 1, marks_points ? file.point_count() : file.cell_count(), solid, "UInt8");
            (velocity_at_points ? file.points : file.cells) +=
                vti_array("U", 3, velocity_at_points ? file.point_count() : file.cell_count(),
                          [](std::size_t) { return 1.0; });
            put("s" + std::to_string(time) + ".vti", file.text());
        }
        put("s.pvd", pvd_text({{"0", "s0.vti"}, {"1", "s1.vti"}, {"2", "s2.vti"}}));
    }

    // The places along the row that have no velocity.
    std::set<std::size_t> gaps(std::size_t time) const {
        std::set<std::size_t> out;
        const auto values = velocity(time);
        for (std::size_t node = 0; node < values.size() / 3; ++node)
            if (!std::isfinite(values[3 * node]))
                out.insert(node % 6);
        return out;
    }
};

TEST_F(MovingBody, EndsTheDataUnlessItIsSaidWhatToDo) {
    put_series(true, true);
    const auto refused = run("s.pvd");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.errors.find("s1.vti (time-step 1) has another mask than s0.vti"),
              std::string::npos)
        << refused.errors;
    EXPECT_NE(refused.errors.find("--mask gap"), std::string::npos) << refused.errors;
}

TEST_F(MovingBody, IsLeftOutWhereItIsAtEachTime) {
    for (const bool marks_points : {true, false})
        for (const bool velocity_at_points : {true, false}) {
            put_series(marks_points, velocity_at_points);
            ASSERT_EQ(run("s.pvd", {"--mask", "gap"}).status, 0);
            for (std::size_t time = 0; time < 3; ++time)
                EXPECT_EQ(gaps(time), (std::set{time, time + 1}))
                    << marks_points << velocity_at_points << time;
            EXPECT_TRUE(reader()->mask().empty());
        }
}

TEST_F(MovingBody, MayBeAScalarLikeOthers) {
    put_series(true, true);
    ASSERT_EQ(run("s.pvd", {"--mask", "scalar"}).status, 0);
    EXPECT_EQ(gaps(1), std::set<std::size_t>{});
    ASSERT_EQ(manifest().layout.scalars.size(), 1u);
    const auto values = reader()->load_scalar(0, 1, {});
    ASSERT_TRUE(values);
    EXPECT_EQ(reinterpret_cast<const float*>(values->bytes().data())[1], 1.0f);
}

} // namespace
} // namespace wakesurf::importer::moving_body_test
