// What is said of a folder that is not this process's to write in: whose it is, who asks, and the command that mends it.
#include "server/app/output_files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/value_of.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>

namespace wakesurf::tests::output_files_test {

namespace fs = std::filesystem;

namespace {

/// Root writes everywhere, so there it asks as somebody else; `folder` is then root's.
template <class Ask>
auto as_a_user(Ask ask) {
    constexpr uid_t nobody = 65534;
    const bool root = ::geteuid() == 0;
    if (root && ::seteuid(nobody) != 0)
        throw std::runtime_error("cannot become another user");
    auto answer = ask();
    if (root && ::seteuid(0) != 0)
        throw std::runtime_error("cannot become root again");
    return answer;
}

} // namespace

TEST(WritableFolder, OfSomebodyElseIsNamedWithItsOwnerAndTheCure) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms{0555});
    for (const fs::path& asked : {folder.path(), folder.path() / "not" / "there"}) {
        const auto answer = as_a_user([&] { return server::check_writable(asked, "--state"); });
        ASSERT_FALSE(answer);
        const std::string words = answer.error().message + "; " + answer.error().hint;
        if (::geteuid() == 0) {
            EXPECT_TRUE(holds(words, "belongs to user 0, this program runs as user 65534"));
            EXPECT_TRUE(holds(words, "chown -R 65534 FOLDER"));
        } else {
            EXPECT_NE(words.find(fmt::format("its owner, user {}", ::geteuid())), std::string::npos)
                << words;
            EXPECT_TRUE(holds(words, "chmod u+wx"));
        }
        EXPECT_TRUE(holds(words, "--state"));
        EXPECT_NE(words.find(folder.path().string()), std::string::npos) << words;
    }
    fs::permissions(folder.path(), fs::perms{0755});
}

TEST(WritableFolder, OfOnesOwnIsFineAlsoWhereItIsYetToBeMade) {
    const TemporaryFolder folder;
    EXPECT_TRUE(server::check_writable(folder.path(), "--store"));
    EXPECT_TRUE(server::check_writable(folder.path() / "yet" / "to" / "be", "--store"));
    EXPECT_FALSE(fs::exists(folder.path() / "yet"));
}

} // namespace wakesurf::tests::output_files_test
