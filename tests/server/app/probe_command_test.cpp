// `wakesurf probe` as its user meets it: a table at points, along a line, over time.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace wakesurf::server::probe_command_test {

namespace {

struct Table {
    ChildOutcome outcome;
    std::string head;
    std::vector<std::vector<std::string>> rows;

    double at(std::size_t row, std::size_t column) const {
        return std::stod(rows.at(row).at(column));
    }
};

/// Runs the command with a file to write.
Table probed(std::vector<std::string> arguments) {
    const auto file =
        std::filesystem::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
    arguments.insert(arguments.begin(), "probe");
    arguments.insert(arguments.end(), {"-o", file.string()});
    auto outcome = run_child(tests::server_program(), arguments, 0, [](std::string_view) {}, {});
    EXPECT_TRUE(outcome) << outcome.error().message;
    Table out{outcome.value_or(ChildOutcome{.exit_status = -1, .signal = 0, .errors = {}}), {}, {}};
    std::ifstream stream(file);
    std::getline(stream, out.head);
    for (std::string line; std::getline(stream, line);) {
        auto& row = out.rows.emplace_back();
        std::istringstream cells(line + ",");
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(cell);
    }
    stream.close();
    std::filesystem::remove(file);
    return out;
}

} // namespace

TEST(ProbeCommand, SamplesEvenlyAlongALineWithCorners) {
    // In a rigid rotation at 1 about z the speed is the distance from the axis.
    const Table found = probed({"flow:rotation?w=0", "--line", "0,0,0:1,0,0:1,1,0", "--points", "5",
                                "--fields", "speed,velocity,vorticity_z"});
    ASSERT_EQ(found.outcome.exit_status, 0) << found.outcome.errors;
    EXPECT_EQ(found.head, "distance,x,y,z,time,speed,velocity_x,velocity_y,velocity_z,vorticity_z");
    ASSERT_EQ(found.rows.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_DOUBLE_EQ(found.at(i, 0), 0.5 * static_cast<double>(i));
        EXPECT_DOUBLE_EQ(found.at(i, 1), std::min(1.0, 0.5 * static_cast<double>(i)));
        EXPECT_NEAR(found.at(i, 5), std::hypot(found.at(i, 1), found.at(i, 2)), 1e-6);
        EXPECT_NEAR(found.at(i, 9), 2.0, 1e-4);
    }
}

TEST(ProbeCommand, HasARowForEachTimeAndPointAndNothingOutsideOfTheFluid) {
    const Table found = probed({"--at", "0.5,0.25,0", "--at", "0.5,9,0", "flow:double-gyre",
                                "--times", "0:4:2", "--fields", "speed"});
    ASSERT_EQ(found.outcome.exit_status, 0) << found.outcome.errors;
    EXPECT_EQ(found.head.substr(0, 10), "time,x,y,z");
    ASSERT_EQ(found.rows.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_DOUBLE_EQ(found.at(i, 0), 2.0 * static_cast<double>(i / 2));
        EXPECT_EQ(found.rows[i].back().empty(), i % 2 == 1);
    }
    EXPECT_NE(found.outcome.errors.find("3 of 6 rows are of no place in the fluid"),
              std::string::npos)
        << found.outcome.errors;
}

TEST(ProbeCommand, RefusesInWords) {
    const auto refused = [](const std::vector<std::string>& arguments, const std::string& words) {
        const Table found = probed(arguments);
        EXPECT_NE(found.outcome.exit_status, 0) << words;
        EXPECT_TRUE(found.rows.empty());
        EXPECT_NE(found.outcome.errors.find(words), std::string::npos) << found.outcome.errors;
    };
    refused({"flow:tornado"}, "neither --at nor --line says where");
    refused({"flow:tornado", "--at", "1,2"}, "'1,2' is no point");
    refused({"flow:tornado", "--line", "0,0,0:0,0,0"}, "it has no length");
    refused({"flow:tornado", "--at", "0,0,0", "--fields", "vortcity"}, "did you mean vorticity");
    refused({"flow:double-gyre", "--at", "0,0,0", "--times", "0:10:1e-5"}, "at most 100000");
    refused({"flow:sphere", "--at", "0,0,0", "--times", "0:1:1"}, "the data have one time");
}

} // namespace wakesurf::server::probe_command_test
