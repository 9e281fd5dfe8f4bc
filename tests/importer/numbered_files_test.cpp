// Which files are the series of one of them. The files are empty: only their names count.
#include "importer/sources/series/numbered_files.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::importer::numbered_files_test {
namespace {

using Names = std::vector<std::string>;

class NumberedFiles_ : public testing::Test {
  protected:
    void put(const Names& names) const {
        for (const auto& name : names)
            tests::write_file(folder_ / name, "x");
    }

    Names series(const std::string& name, bool alone = false) const {
        const auto found = numbered_files(folder_ / name, alone);
        if (!found)
            return {found.error().message};
        Names out;
        for (const auto& file : found->files)
            out.push_back(file.filename().string());
        return out;
    }

    // Each of these names stands for all of them, in this order, whatever else is there.
    void expect_series(const Names& names) const {
        put(names);
        for (const auto& name : names)
            EXPECT_EQ(series(name), names) << name;
    }

    tests::TemporaryFolder folder_;
};

Names counted(
    const std::string& prefix, int first, int last, const std::string& suffix, int width) {
    Names out;
    for (int i = first; i <= last; ++i) {
        std::string digits = std::to_string(i);
        digits.insert(
            0, static_cast<std::size_t>(std::max(0, width - static_cast<int>(digits.size()))), '0');
        out.push_back(prefix + digits + suffix);
    }
    return out;
}

TEST_F(NumberedFiles_, AreInTheOrderOfTheirNumbers) {
    expect_series(counted("plain_", 1, 12, ".vtu", 0));
    expect_series(counted("padded", 0, 11, ".vtk", 4));
    expect_series(counted("", 8, 11, ".vtu", 0));
    expect_series({"mixed-005.vtk", "mixed-10.vtk", "mixed-1000.vtk"});
    expect_series({"t_-10.vtu", "t_-2.vtu", "t_0.vtu", "t_3.vtu"});
    expect_series({"e_1e-05.vtu", "e_0.001.vtu", "e_0.02.vtu", "e_1.vtu"});
    expect_series({"minus-1.vtu", "minus-2.vtu"});
}

TEST_F(NumberedFiles_, TheLastNumberOfANameCountsWhereverItIs) {
    expect_series(counted("a_", 8, 11, "_b.vtk", 0));
    expect_series(counted("a_", 8, 11, "_c.vtk", 0));
    expect_series(counted("run3.step", 8, 11, ".cell.vtk", 4));
    expect_series(counted("Blast.block0.out1.", 0, 3, ".vtk", 5));
    expect_series(counted("Blast.block0.out2.", 0, 3, ".vtk", 5));
    expect_series(counted("Blast.block1.out2.", 0, 3, ".vtk", 5));
    expect_series(counted("v1.2.", 3, 11, ".vtk", 0));
    put({"grid2d.vtk", "grid3d.vtk"});
    EXPECT_EQ(series("grid3d.vtk"), Names{"grid3d.vtk"}) << "3d is no number";
}

TEST_F(NumberedFiles_, ADotSeparatesUnlessTheNumbersAreDecimals) {
    expect_series(counted("run2.", 1, 12, ".vti", 0));
    expect_series(counted("run3.", 8, 10, ".vti", 0));
    expect_series(counted("many1.", 0, 9, ".vti", 0));
    expect_series(counted("many2.", 0, 9, ".vti", 0));
    expect_series({"gaps1.1.vti", "gaps1.2.vti", "gaps1.11.vti", "gaps1.12.vti"});
    expect_series({"only1.00000.vti"});
    expect_series({"only2.00000.vti"});
    expect_series({"flow_0.5.vtu", "flow_0.75.vtu", "flow_1.0.vtu", "flow_10.25.vtu"});
    expect_series({"t0.1.vtu", "t0.15.vtu", "t0.2.vtu", "t1.vtu"});
    expect_series({"time_0.00.vtu", "time_0.05.vtu", "time_0.10.vtu", "time_2.00.vtu"});
    expect_series({"s_0.05.vtu", "s_0.2.vtu", "s_0.37.vtu"});
    Names hundredths;
    for (int i = 0; i < 120; ++i)
        hundredths.push_back("h_" + std::to_string(i / 100) + "." +
                             std::string(i % 100 < 10 ? "0" : "") + std::to_string(i % 100) +
                             ".vtk");
    expect_series(hundredths);
}

TEST_F(NumberedFiles_, PaddedAndUnpaddedNumbersAreTwoSeriesWhereTheyMeet) {
    expect_series({"f_1.vtu", "f_2.vtu", "f_10.vtu"});
    put({"f_01.vtu", "f_02.vtu"});
    EXPECT_EQ(series("f_01.vtu"), (Names{"f_01.vtu", "f_02.vtu", "f_10.vtu"}));
    EXPECT_EQ(series("f_2.vtu"), (Names{"f_1.vtu", "f_2.vtu", "f_10.vtu"}));
    EXPECT_EQ(series("f_*.vtu"), Names{"f_01.vtu and f_1.vtu have the same number"});
}

TEST_F(NumberedFiles_, OneIsAloneOnRequestOrWithoutOthers) {
    put(counted("p_", 1, 3, ".vtu", 0));
    EXPECT_EQ(series("p_2.vtu", true), Names{"p_2.vtu"});
    put({"mesh.vtu", "case_7.vtu"});
    EXPECT_EQ(series("mesh.vtu"), Names{"mesh.vtu"});
    EXPECT_EQ(series("case_7.vtu"), Names{"case_7.vtu"});
}

} // namespace
} // namespace wakesurf::importer::numbered_files_test
