#include "protocol/api/generated/names.hpp"

#include <gtest/gtest.h>

namespace wakesurf::protocol::names_test {

TEST(Names, ReadBackToTheValueTheyName) {
    using core::Accuracy, core::Direction, core::Interpolation, core::SurfaceKind;
    for (const auto kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        EXPECT_EQ(surface_kind(name(kind)), kind) << name(kind);
    for (const auto each : {Direction::Forward, Direction::Backward, Direction::Both})
        EXPECT_EQ(direction(name(each)), each) << name(each);
    for (const auto each : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact})
        EXPECT_EQ(accuracy(name(each)), each) << name(each);
    for (const auto each : {Interpolation::Linear, Interpolation::Smooth})
        EXPECT_EQ(interpolation(name(each)), each) << name(each);
}

TEST(Names, AreNothingElse) {
    for (const auto* word : {"", "Stream", "stream ", "iso", "forwards", "good"}) {
        EXPECT_FALSE(surface_kind(word)) << word;
        EXPECT_FALSE(direction(word)) << word;
        EXPECT_FALSE(accuracy(word)) << word;
        EXPECT_FALSE(interpolation(word)) << word;
    }
}

} // namespace wakesurf::protocol::names_test
