#include "protocol/api/generated/names.hpp"

#include <gtest/gtest.h>

namespace wakesurf::protocol::names_test {

using core::Accuracy, core::Direction, core::Interpolation, core::SurfaceKind;

TEST(Names, ReadBackToTheValueTheyName) {
    for (const auto kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        EXPECT_EQ(value_of<SurfaceKind>(name(kind)), kind) << name(kind);
    for (const auto each : {Direction::Forward, Direction::Backward, Direction::Both})
        EXPECT_EQ(value_of<Direction>(name(each)), each) << name(each);
    for (const auto each : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact})
        EXPECT_EQ(value_of<Accuracy>(name(each)), each) << name(each);
    for (const auto each : {Interpolation::Linear, Interpolation::Smooth})
        EXPECT_EQ(value_of<Interpolation>(name(each)), each) << name(each);
}

TEST(Names, AreNothingElse) {
    for (const auto* word : {"", "Stream", "stream ", "iso", "forwards", "good"}) {
        EXPECT_FALSE(value_of<SurfaceKind>(word)) << word;
        EXPECT_FALSE(value_of<Direction>(word)) << word;
        EXPECT_FALSE(value_of<Accuracy>(word)) << word;
        EXPECT_FALSE(value_of<Interpolation>(word)) << word;
    }
}

} // namespace wakesurf::protocol::names_test
