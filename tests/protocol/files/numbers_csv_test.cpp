// Numbers as CSV: units where the data have them, and nothing where a number is not known.
#include "protocol/files/numbers_csv.hpp"

#include <gtest/gtest.h>

namespace wakesurf::protocol::numbers_csv_test {

namespace {

core::NumberTable table() {
    core::NumberTable out;
    out.columns = {{"time", 0, 1}, {"area", 2, 0}, {"flux", 3, -1}, {"entered", 0, 0}};
    out.rows = {{0.5, 1e-300, -2.0, core::not_known}, {1.0, 0.1, 0.0, 1.0}};
    out.notes = {{"not \"met\"", "torn, twice"}, {}};
    return out;
}

} // namespace

TEST(NumbersCsv, NamesUnitsAndLeavesOutWhatIsNotKnown) {
    EXPECT_EQ(numbers_csv(table(), "m", "s"), "time [s],area [m^2],flux [m^3/s],entered,notes\n"
                                              "0.5,1e-300,-2,,\"not \"\"met\"\"; torn, twice\"\n"
                                              "1,0.1,0,1,\n");
}

TEST(NumbersCsv, HasNoUnitsWhereTheDataHaveNone) {
    EXPECT_TRUE(numbers_csv(table(), "", "").starts_with("time,area,flux,entered,notes\n"));
    EXPECT_TRUE(numbers_csv(table(), "m", "").starts_with("time,area [m^2],flux,entered,notes\n"));
}

TEST(NumbersCsv, HasTheUnitOfAFieldAndNoNotesWhereNothingIsSaid) {
    core::NumberTable samples;
    samples.columns = {{"x", 1, 0}, {"mean_p", 0, 0, core::not_known, "Pa"}};
    samples.rows = {{0.5, 2.0}, {1.0, core::not_known}};
    EXPECT_EQ(numbers_csv(samples, "m", "s"), "x [m],mean_p [Pa]\n0.5,2\n1,\n");
}

TEST(NumbersCsv, QuotesUnitsThatAStrangerWrote) {
    EXPECT_TRUE(
        numbers_csv(table(), "a,\"b", "s").starts_with("time [s],\"area [a,\"\"b^2]\",\"flux"));
}

} // namespace wakesurf::protocol::numbers_csv_test
