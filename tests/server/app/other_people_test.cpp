// What a server does where other people of the machine, or the reader of its output, could get in its way.
#include "server/base/private_file.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/server_process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/value_of.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace wakesurf::tests::other_people_test {

namespace fs = std::filesystem;
using server::check_private_folder;
using server::open_private_file;
using server::read_named_secret;
using server::read_private_file;
using server::write_private_file;

namespace {

const std::string secret(64, 's');
constexpr uid_t somebody = 4711;

fs::perms mode(const fs::path& path) {
    return fs::status(path).permissions();
}

std::string words(const core::Error& error) {
    return error.message + "; " + error.hint;
}

struct Ended {
    int status = -1;
    std::string errors;
};

/// A server that is not to start.
Ended serve(const std::string& arguments, const std::string& port = "0") {
    std::FILE* const pipe =
        ::popen(("timeout 60 " + server_program() + " serve flow:abc --listen 127.0.0.1:" + port +
                 " " + arguments + " 2>&1")
                    .c_str(),
                "r");
    Ended out;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        out.errors += static_cast<char>(c);
    out.status = WEXITSTATUS(::pclose(pipe));
    return out;
}

/// Only root can give files away.
bool gave_away(const fs::path& path) {
    return ::lchown(path.c_str(), somebody, somebody) == 0;
}

} // namespace

TEST(PrivateFile, IsAPlainFileOfThisUserAndNothingElse) {
    const TemporaryFolder folder;
    const auto refused = [&](const char* name) {
        const auto read = read_private_file(folder / name, 100);
        const auto opened = open_private_file(folder / name, O_WRONLY | O_CREAT);
        EXPECT_FALSE(opened) << name;
        return read ? std::string("read") : words(read.error());
    };
    write_file(folder / "mine", "precious");
    fs::create_symlink(folder / "mine", folder / "link");
    fs::create_symlink(folder / "nothing", folder / "loose");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_directory(folder / "folder");
    EXPECT_TRUE(holds(refused("link"), "is a link"));
    EXPECT_TRUE(holds(refused("loose"), "is a link"));
    EXPECT_TRUE(holds(refused("pipe"), "not a plain file")) << "and does not wait";
    EXPECT_NE(refused("folder"), "read");
    fs::create_hard_link(folder / "mine", folder / "second");
    EXPECT_TRUE(holds(refused("second"), "second name"));
    fs::remove(folder / "second");
    EXPECT_EQ(*read_private_file(folder / "mine", 100), "precious");
    EXPECT_EQ(read_private_file(folder / "mine", 7).error().code, core::Error::Code::Corrupt);
    EXPECT_EQ(read_private_file(folder / "none", 7).error().code, core::Error::Code::NotFound);
    EXPECT_FALSE(fs::exists(folder / "nothing"));
    if (gave_away(folder / "mine")) {
        EXPECT_TRUE(holds(refused("mine"), "belongs to user 4711"));
    }
}

TEST(PrivateFile, IsTakenFromTheEyesOfOthers) {
    const TemporaryFolder folder;
    write_file(folder / "mine", "precious");
    fs::permissions(folder / "mine", fs::perms{0664});
    EXPECT_TRUE(read_private_file(folder / "mine", 100));
    EXPECT_EQ(mode(folder / "mine"), fs::perms{0600});
}

TEST(PrivateFile, IsReplacedAndALinkInItsPlaceNotFollowed) {
    const TemporaryFolder folder;
    write_file(folder / "other", "precious");
    fs::create_symlink(folder / "other", folder / "file");
    ASSERT_TRUE(write_private_file(folder / "file", "new"));
    EXPECT_EQ(*read_private_file(folder / "file", 100), "new");
    EXPECT_EQ(*read_private_file(folder / "other", 100), "precious");
}

TEST(NamedSecret, MayBeBehindALinkOfOnesOwnAndSaysWhereOthersCouldReadIt) {
    const TemporaryFolder folder;
    write_file(folder / "token", secret);
    fs::permissions(folder / "token", fs::perms{0600});
    fs::create_symlink("token", folder / "link");
    fs::create_symlink("link", folder / "longer");
    fs::create_symlink("round", folder / "round");
    EXPECT_EQ(read_named_secret(folder / "longer", 100)->text, secret);
    EXPECT_EQ(read_named_secret(folder / "longer", 100)->warning, "");
    EXPECT_FALSE(read_named_secret(folder / "round", 100));
    fs::permissions(folder / "token", fs::perms{0640});
    EXPECT_NE(read_named_secret(folder / "link", 100)->warning, "");
    if (gave_away(folder / "link")) {
        const auto read = read_named_secret(folder / "link", 100);
        ASSERT_FALSE(read);
        EXPECT_TRUE(holds(words(read.error()), "link of user 4711"));
        ASSERT_TRUE(gave_away(folder / "token"));
        EXPECT_FALSE(read_named_secret(folder / "token", 100));
    }
}

TEST(PrivateFolder, IsOnesOwnAndNoOneElseMayWriteThere) {
    const TemporaryFolder folder;
    const auto refusal = [&](unsigned bits, bool shared) {
        fs::permissions(folder.path(), fs::perms{bits});
        const auto checked = check_private_folder(folder.path(), "--state", shared);
        return checked ? std::string() : words(checked.error());
    };
    EXPECT_EQ(refusal(0700, false), "");
    EXPECT_EQ(refusal(0755, false), "");
    EXPECT_TRUE(holds(refusal(0775, false), "--state: others can write"));
    EXPECT_TRUE(holds(refusal(0757, true), "chmod go-w"));
    EXPECT_NE(refusal(01777, false), "");
    EXPECT_EQ(refusal(01777, true), "");
    EXPECT_EQ(refusal(0700, true), "");
    if (gave_away(folder.path())) {
        EXPECT_TRUE(holds(refusal(0755, true), "belongs to user 4711"));
        EXPECT_TRUE(holds(refusal(0777, false), "belongs to user 4711"));
    }
}

TEST(StateOfOthers, IsRefusedBeforeAnythingInItIsTouched) {
    const TemporaryFolder folder;
    const fs::path state = folder / "state";
    fs::create_directory(state);
    write_file(folder / "precious", "precious");
    for (const char* name : {"starts", "sessions.sqlite.commits", "sessions.sqlite",
                             "sessions.sqlite-wal", "ended-logins", "login-key"}) {
        fs::permissions(state, fs::perms{0700});
        fs::create_symlink(folder / "precious", state / name);
        const auto ended = serve("--state " + state.string());
        EXPECT_EQ(ended.status, 1) << name;
        EXPECT_TRUE(holds(ended.errors, "is a link")) << name << ended.errors;
        EXPECT_EQ(read_file(folder / "precious"), "precious") << name;
        fs::remove(state / name);
    }
    const fs::path open = folder / "open";
    fs::create_directory(open);
    fs::permissions(open, fs::perms{0777});
    const auto ended = serve("--state " + open.string());
    EXPECT_EQ(ended.status, 1);
    EXPECT_TRUE(holds(ended.errors, "others can write to the folder (mode 0777)"));
    EXPECT_TRUE(fs::is_empty(open));
}

TEST(TokenFile, IsMendedWithAWordWhereOthersCanReadItAndRefusedWhereItIsTheirs) {
    const TemporaryFolder folder;
    const std::string file = (folder / "token").string();
    write_file(file, secret + "\n");
    fs::permissions(file, fs::perms{0644});
    {
        ServerProcess server({"flow:abc", "--token-file", file});
        EXPECT_EQ(server.token(), secret);
        EXPECT_EQ(mode(file), fs::perms{0600});
        EXPECT_TRUE(holds(server.stop().log, "event=token_was_readable"));
    }
    const auto refused = [&] {
        const auto ended = serve("--token-file " + file);
        EXPECT_EQ(ended.status, 1);
        return ended.errors;
    };
    if (gave_away(file)) {
        EXPECT_TRUE(holds(refused(), "belongs to user 4711"));
    }
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    EXPECT_TRUE(holds(refused(), "not a plain file"));
}

TEST(NewToken, ChangesNothingWhereTheServerDoesNotStart) {
    const TemporaryFolder folder;
    const std::string file = (folder / "token").string();
    const ServerProcess other({"flow:abc"});
    write_file(file, secret + "\n");
    fs::permissions(file, fs::perms{0600});
    const std::string port = std::to_string(other.port());
    const auto taken = serve("--token-file " + file + " --new-token", port);
    EXPECT_EQ(taken.status, 1);
    EXPECT_EQ(read_file(file), secret + "\n");
    const auto bad = serve("--token-file " + file + " --new-token --tls-cert none --tls-key none");
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(read_file(file), secret + "\n");
}

TEST(NewToken, IsNotForAFileThatAnotherServerUses) {
    const TemporaryFolder folder;
    const std::string file = (folder / "token").string();
    std::string first;
    {
        const ServerProcess user({"flow:abc", "--token-file", file});
        const ServerProcess beside({"flow:abc", "--token-file", file});
        EXPECT_EQ(user.token(), beside.token()) << "several may use one";
        first = read_file(file);
        const auto refused = serve("--token-file " + file + " --new-token");
        EXPECT_EQ(refused.status, 1);
        EXPECT_TRUE(holds(refused.errors, "in use by another server"));
        EXPECT_EQ(read_file(file), first);
    }
    const ServerProcess alone({"flow:abc", "--token-file", file, "--new-token"});
    EXPECT_NE(read_file(file), first);
    const auto again = serve("--token-file " + file + " --new-token");
    EXPECT_EQ(again.status, 1) << "the fresh file is in use as well";
}

} // namespace wakesurf::tests::other_people_test
