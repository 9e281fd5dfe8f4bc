// Data in which it is not clear which field is the velocity, until somebody says so.
#include "tests/server/data/catalogue_bench.hpp"
#include "tests/support/vti_text.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::chosen_velocity_test {
namespace {

void write_two_phases(const TemporaryFolder& folder) {
    auto two = sample_vti();
    two.points = vti_array("U.air", 3, two.point_count(), [](std::size_t) { return 1.0; }) +
                 vti_array("U.water", 3, two.point_count(), [](std::size_t) { return 2.0; });
    write_file(folder / "two.vti", two.text());
}

TEST(ChosenVelocity, IsTakenWhileNothingIsShown) {
    const TemporaryFolder folder;
    write_two_phases(folder);
    CatalogueBench bench({(folder / "two.vti").string(), "flow:abc"});
    const auto unclear = bench.wait_until_settled("two");
    ASSERT_EQ(unclear.state, DatasetState::Failed);
    EXPECT_EQ(unclear.velocities, (std::vector<std::string>{"U.air", "U.water"}));
    EXPECT_NE(unclear.error->message.find("U.air (3 components, point), U.water (3 components, "
                                          "point) (choose one with --velocity NAME"),
              std::string::npos)
        << unclear.error->message;
    ASSERT_TRUE(bench.catalogue->choose_velocity("two", "U.oil").has_value());
    const auto wrong = bench.wait_until_settled("two");
    EXPECT_NE(wrong.error->message.find("there is no field U.oil"), std::string::npos);
    EXPECT_EQ(wrong.velocities, unclear.velocities);
    ASSERT_TRUE(bench.catalogue->choose_velocity("two", "U.water").has_value());
    const auto chosen = bench.wait_until_settled("two");
    EXPECT_EQ(chosen.state, DatasetState::Ready);
    EXPECT_TRUE(chosen.velocities.empty());
    EXPECT_EQ(bench.catalogue->find("two").value()->info.velocity, "U.water");
    EXPECT_TRUE(bench.catalogue->choose_velocity("two", "U.water").has_value()) << "as it is";
    const auto other = bench.catalogue->choose_velocity("two", "U.air");
    ASSERT_FALSE(other.has_value());
    EXPECT_EQ(other.error().message, "two is shown with the velocity U.water");
    EXPECT_EQ(bench.catalogue->find("two").value()->info.velocity, "U.water");
    EXPECT_EQ(bench.catalogue->choose_velocity("none", "U").error().code,
              core::Error::Code::NotFound);
    EXPECT_NE(bench.catalogue->choose_velocity("abc", "U")
                  .error()
                  .message.find("abc is a built-in flow, which has one velocity"),
              std::string::npos);
}

TEST(ChosenVelocity, IsThatOfLaterServersUnlessTheyAreToldAnother) {
    const TemporaryFolder folder;
    write_two_phases(folder);
    const std::vector<std::string> arguments{(folder / "two.vti").string()};
    {
        CatalogueBench bench(arguments, folder / "stores");
        ASSERT_EQ(bench.wait_until_settled("two").state, DatasetState::Failed);
        ASSERT_TRUE(bench.catalogue->choose_velocity("two", "U.oil").has_value());
        ASSERT_EQ(bench.wait_until_settled("two").state, DatasetState::Failed);
    }
    {
        CatalogueBench bench(arguments, folder / "stores");
        ASSERT_EQ(bench.wait_until_settled("two").velocities.size(), 2u) << "it did not work";
        ASSERT_TRUE(bench.catalogue->choose_velocity("two", "U.water").has_value());
        ASSERT_EQ(bench.wait_until_settled("two").state, DatasetState::Ready);
    }
    CatalogueBench later(arguments, folder / "stores");
    EXPECT_EQ(later.wait_until_settled("two").state, DatasetState::Ready);
    EXPECT_EQ(later.catalogue->find("two").value()->info.velocity, "U.water");
    command::SourceOptions told;
    told.velocity = "U.air";
    CatalogueBench other(arguments, folder / "stores", importer_program(), 4, told);
    EXPECT_EQ(other.wait_until_settled("two").state, DatasetState::Ready);
    EXPECT_EQ(other.catalogue->find("two").value()->info.velocity, "U.air");
}

} // namespace
} // namespace wakesurf::server::chosen_velocity_test
