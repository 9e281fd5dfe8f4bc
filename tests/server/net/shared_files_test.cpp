// Files made once for many, by hand: jobs and the loop run when the test says so.
#include "server/net/shared_files.hpp"
#include "tests/support/server/hand_loop.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace wakesurf::server::shared_files_test {

namespace {

using core::MemoryAccount;
using core::MemoryUse;

class SharedFilesTest : public testing::Test {
  protected:
    /// How often a file was asked for, made and had.
    struct Log {
        int made = 0;
        std::vector<std::string> had;
    };

    SharedFiles::Make make(const std::string& bytes) {
        return [this, bytes](const std::stop_token& stop,
                             MemoryAccount::Share& share) -> core::Result<std::string> {
            order_.push_back(bytes);
            if (stop.stop_requested())
                return core::fail(core::Error::Code::Cancelled, "stopped");
            ++log_.made;
            EXPECT_TRUE(share.grow_to(2 * bytes.size()));
            return bytes;
        };
    }

    void get(const std::string& tag, const std::string& asker = "a", std::stop_token gone = {}) {
        files_.get(tag, asker, make(tag), gone, [this](const core::Result<File>& file) {
            log_.had.push_back(file ? **file : "error: " + file.error().message);
        });
    }

    void run() {
        while (pool_.turn()) {
        }
        bool done = false;
        loop_.post([&] { done = true; });
        loop_.turn_until([&] { return done; });
    }

    MemoryAccount account_{1000};
    tests::HandLoop loop_;
    ComputePool pool_{ComputePool::ByHand{}};
    SharedFiles files_{loop_, pool_, &account_};
    Log log_;
    std::vector<std::string> order_;
};

using Had = std::vector<std::string>;

} // namespace

TEST_F(SharedFilesTest, AreMadeOnceForAllWhoAskMeanwhile) {
    get("x", "a");
    get("x", "b");
    get("x", "a");
    EXPECT_EQ(files_.making(), 1u);
    run();
    EXPECT_EQ(log_.made, 1);
    EXPECT_EQ(log_.had, (Had{"x", "x", "x"}));
    EXPECT_EQ(files_.making(), 0u);
}

TEST_F(SharedFilesTest, AreKeptForTheNextWhoAsks) {
    get("x");
    run();
    get("x");
    EXPECT_EQ(log_.had, (Had{"x", "x"})) << "at once";
    EXPECT_EQ(log_.made, 1);
    EXPECT_EQ(account_.used(MemoryUse::Downloads), 1u) << "what making it took is free";
}

TEST_F(SharedFilesTest, TakeTurnsByWhoAsks) {
    for (const std::string tag : {"1", "2", "3"})
        get(tag, "many");
    get("mine", "me");
    run();
    EXPECT_EQ(order_, (std::vector<std::string>{"1", "mine", "2", "3"}));
}

TEST_F(SharedFilesTest, AreNotMadeWhenAllWhoWaitedAreGone) {
    std::stop_source one, other;
    get("x", "a", one.get_token());
    get("x", "b", other.get_token());
    one.request_stop();
    EXPECT_EQ(files_.making(), 1u);
    other.request_stop();
    EXPECT_EQ(files_.making(), 0u);
    run();
    EXPECT_EQ(log_.made, 0);
    EXPECT_EQ(log_.had, Had{});
}

TEST_F(SharedFilesTest, AreMadeAnewForWhoAsksAfterAllWereGone) {
    std::stop_source gone;
    get("x", "a", gone.get_token());
    gone.request_stop();
    get("x", "b");
    run();
    EXPECT_EQ(log_.made, 1);
    EXPECT_EQ(log_.had, Had{"x"});
}

TEST_F(SharedFilesTest, WhoIsGoneAlreadyWaitsForNothing) {
    std::stop_source gone;
    gone.request_stop();
    get("x", "a", gone.get_token());
    EXPECT_EQ(files_.making(), 0u);
    run();
    EXPECT_EQ(log_.had, Had{});
}

TEST_F(SharedFilesTest, GiveTheirMemoryBackWhereOthersNeedItButNotWhatSomebodyReads) {
    get(std::string(300, 'x'));
    File read;
    files_.get(std::string(200, 'y'), "a", make(std::string(200, 'y')), {},
               [&](const core::Result<File>& file) { read = *file; });
    run();
    EXPECT_EQ(account_.used(MemoryUse::Downloads), 500u);
    auto other = account_.open(MemoryUse::Surfaces);
    EXPECT_TRUE(other.grow_to(800));
    EXPECT_EQ(account_.used(MemoryUse::Downloads), 200u);
    EXPECT_EQ(*read, std::string(200, 'y'));
    EXPECT_FALSE(other.grow_to(900)) << "someone reads the rest";
    read.reset();
    EXPECT_TRUE(other.grow_to(900));
    EXPECT_EQ(account_.used(MemoryUse::Downloads), 0u);
}

TEST_F(SharedFilesTest, ThatCannotBeMadeSayWhyToAllAndAreTriedAgain) {
    const auto failing = [this](bool known) {
        files_.get(
            "x", "a",
            [known](const std::stop_token&, MemoryAccount::Share&) -> core::Result<std::string> {
                if (known)
                    return core::fail(core::Error::Code::OverLimit, "too large");
                throw std::runtime_error("a library's at /somewhere");
            },
            {},
            [this](const core::Result<File>& file) { log_.had.push_back(file.error().message); });
    };
    failing(true);
    run();
    failing(false);
    run();
    EXPECT_EQ(log_.had, (Had{"too large", "making the file failed inside the server"}));
    get("x");
    run();
    EXPECT_EQ(log_.had.back(), "x");
}

TEST_F(SharedFilesTest, EndWithThoseWhoWouldHaveThem) {
    auto files = std::make_unique<SharedFiles>(loop_, pool_, &account_);
    bool told = false;
    files->get("x", "a", make("x"), {}, [&](const core::Result<File>&) { told = true; });
    files.reset();
    run();
    EXPECT_FALSE(told);
    EXPECT_EQ(log_.made, 0);
}

} // namespace wakesurf::server::shared_files_test
