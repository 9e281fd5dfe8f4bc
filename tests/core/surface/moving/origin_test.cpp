// Rows of a moving surface on the rake, and how one is joined with the next.
#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/origin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace wakesurf::core::origin_test {

namespace {

/// Two legs, of 3 and of 1.
const Rake bent{Rake::Kind::Polyline, {{0, 0, 0}, {0, 3, 0}, {0, 3, 1}}, 8};
const Rake round{Rake::Kind::Circle, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 8};

} // namespace

TEST(Columns, AreNumberedAlongTheRakeWithFractionsBetween) {
    for (const Rake& rake : {bent, round}) {
        const Columns columns = make_columns(Origin(SeedingCurve(rake)), 8.0);
        for (std::size_t i = 0; i < columns.s.size(); ++i) {
            const auto number = static_cast<double>(i);
            EXPECT_EQ(columns.column(columns.s[i]), number);
            if (number < columns.count) {
                const double next = i + 1 < columns.s.size() ? columns.s[i + 1] : 1.0;
                EXPECT_NEAR(columns.column(columns.s[i] + 0.25 * (next - columns.s[i])),
                            number + 0.25, 1e-12);
            }
        }
        EXPECT_NEAR(columns.column(1.0), columns.count, 1e-12);
    }
}

TEST(Rows, AreJoinedBetweenEqualSeedsNoMoreThanAColumnApart) {
    const auto flow = *make_analytic_flow("uniform");
    for (const Rake& rake : {bent, round}) {
        const Origin origin{SeedingCurve(rake)};
        const Columns columns = make_columns(origin, 8.0);
        MovingMesh mesh;
        mesh.rectangle = {.closed = columns.closed, .facing = -1.0};
        // The older row has a seed more between two columns, and the third column is missing.
        std::vector<double> seeds = columns.s;
        seeds.insert(seeds.begin() + 1, 0.5 * (seeds[0] + seeds[1]));
        seeds.erase(seeds.begin() + 3);
        const auto older = attach_row(mesh, origin, *flow, seeds, {}).value();
        mesh.time = 1.0;
        // The newer one has none at the last.
        seeds.pop_back();
        const auto newer = attach_row(mesh, origin, *flow, seeds, {}).value();
        join_rows(mesh, columns, newer, older);
        // Of the intervals one is two; the two beside the missing column are none, nor those beside the last.
        const auto whole = static_cast<std::size_t>(columns.count);
        EXPECT_EQ(mesh.triangles.quads(), whole + 1 - 2 - (columns.closed ? 2 : 1));
        EXPECT_EQ(mesh.triangles.violation(), "");
    }
}

} // namespace wakesurf::core::origin_test
