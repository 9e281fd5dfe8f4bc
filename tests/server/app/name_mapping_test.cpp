// What the API says, as the command line says it.
#include "protocol/api/base/methods.hpp"
#include "server/app/name_mapping.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::name_mapping_test {

namespace {

core::Error said(std::string message, std::string hint) {
    return {core::Error::Code::InvalidArgument, std::move(message), std::move(hint)};
}

} // namespace

TEST(OwnWords, NameTheOptionOfAParameterInMessageAndHint) {
    const auto error = with_options(
        said("`releaseUntil` lies after `to`", "raise `maxQuads`, or write `fields` again"));
    EXPECT_EQ(error.message, "--release-until lies after --to");
    EXPECT_EQ(error.hint, "raise --max-quads, or write --fields again");
}

TEST(OwnWords, NameTheCommandThatDoesTheWorkOfAMethod) {
    const auto error =
        with_commands(said("there is no session `s-9`", "`session.list` lists them"));
    EXPECT_EQ(error.message, "there is no session `s-9`");
    EXPECT_EQ(error.hint, "`wakesurf sessions list` lists them");
}

TEST(OwnWords, LeaveOutAHintThatNeedsAMethodWithoutACommand) {
    EXPECT_EQ(with_commands(said("no", "`session.shares` lists them, `session.list` others")).hint,
              "");
    EXPECT_EQ(with_commands(said("no", "move the rake, or an odd ` and `no.such`")).hint,
              "move the rake, or an odd ` and `no.such`");
}

TEST(OwnWords, KnowOnlyMethodsThatThereAre) {
    for (const CommandOfMethod& each : commands_of_methods())
        EXPECT_NE(protocol::described_method(each.method), nullptr) << each.method;
}

} // namespace wakesurf::server::name_mapping_test
