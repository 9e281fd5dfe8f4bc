// Jobs that are no such job, or end, hang and lie: reads are made from files then, and are right.
#include "server/data/bricks/bricks_job.hpp"
#include "server/data/bricks/local_socket.hpp"
#include "tests/server/data/bricks/bricks_fixture.hpp"
#include "tests/server/data/bricks/fake_job.hpp"

#include <sys/stat.h>

#include <functional>

namespace wakesurf::server::bad_jobs_test {
namespace {

using namespace tests;
using namespace std::chrono_literals;

/// Longer than any machine takes.
constexpr auto at_most = 300s;

class BadJobs : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        write_bricks(*folder_ / "s");
        reader_ = reader_of(*folder_ / "s");
        bytes_ = all_bricks(*reader_->bricks());
    }

    static void TearDownTestSuite() {
        reader_.reset();
        folder_.reset();
    }

    BadJobs() {
        const core::BrickLayout& layout = reader_->bricks()->layout();
        hello.shape = {layout.dimensions(), layout.cells(), 4, 3 * layout.nodes_per_brick()};
        hello.ranks = 1;
    }

    /// @param marks  of the store that the job says it holds
    RankBricks::Options job(const std::string& how, const std::string& marks) const {
        RankBricks::Options options;
        options.words = fake_job(how, hello, marks);
        options.program = "wakesurf-bricks";
        options.store = *folder_ / "s";
        options.first_rest = options.longest_rest = 1ms;
        options.patience = options.hung = at_most; // a slow machine changes nothing
        return options;
    }

    RankBricks::Options job(const std::string& how) const { return job(how, reader_->values()); }

    /// It is welcome, and what is read then is right, by files alone.
    void expect_right_by_files(RankBricks::Options options) {
        RankedStore store(reader_, std::move(options));
        store.ranks().begin();
        ASSERT_TRUE(store.ranks().wait_for_job(1, at_most));
        EXPECT_EQ(all_bricks(*store.bricks()), bytes_);
        const auto status = store.ranks().status();
        EXPECT_EQ(status.by_ranks, 0u);
        EXPECT_EQ(status.by_files, bricks_in_all);
    }

    JobHello hello;
    static inline std::unique_ptr<TemporaryFolder> folder_;
    static inline std::shared_ptr<const store::StoreReader> reader_;
    static inline std::vector<float> bytes_;
};

/// The error of the first who comes.
core::Error met(const WantedJob& wanted, std::vector<std::string> words) {
    const LocalDoor door = LocalDoor::open().value();
    words.insert(words.end(), {"wakesurf-bricks", "store", "--socket", door.path().string()});
    const auto job = BricksJob::start(words).value();
    std::optional<OpenFile> guest;
    while (!guest)
        guest = door.let_in();
    for (;;) {
        auto talk = JobTalk::meet(*guest, wanted);
        if (!talk)
            return talk.error();
        if (*talk)
            return {core::Error::Code::Io, "it was let in", ""};
    }
}

WantedJob wanted_by(const store::StoreReader& reader, const BrickShape& shape) {
    return {shape, [&reader](std::string_view marks) { return reader.contradicts(marks); }};
}

} // namespace

TEST_F(BadJobs, OfAnotherShapeOrVersionOrThatAreNoneAreRefusedWithTheReason) {
    const WantedJob wanted = wanted_by(*reader_, hello.shape);
    EXPECT_EQ(met(wanted, job("holds nothing").words).message, "it was let in");
    const JobHello good = hello;
    hello.shape.dimensions[2] += 1;
    EXPECT_EQ(met(wanted, job("holds nothing").words).message,
              "the job holds the bricks of another store");
    hello = good;
    hello.shape.values -= 3;
    EXPECT_EQ(met(wanted, job("holds nothing").words).message,
              "the job holds the bricks of another store");
    hello = good;
    hello.version += 1;
    EXPECT_EQ(met(wanted, job("holds nothing").words).message,
              "the job is of another version of wakesurf");
    hello = good;
    hello.magic += 1;
    EXPECT_EQ(met(wanted, job("holds nothing").words).message,
              "the job sent an invalid message: its first message is not from wakesurf-bricks");
    hello = good;
    EXPECT_EQ(met(wanted, job("holds nothing", "").words).message,
              "the job holds values other than those of the served store");
    EXPECT_EQ(met(wanted, job("holds nothing", std::string(5000, '0')).words).message,
              "the job sent an invalid message: its first message is too short or too long");
    EXPECT_EQ(met(wanted, job("closes before a word").words).message, "the job has ended");
}

TEST_F(BadJobs, OfAnotherGenerationOfTheStoreAreRefused) {
    TemporaryFolder other;
    write_bricks(other / "s", 1.01);
    const auto before = reader_of(other / "s");
    EXPECT_EQ(
        met(wanted_by(*reader_, hello.shape), job("holds nothing", before->values()).words).message,
        "the job holds values other than those of the served store");
}

TEST_F(BadJobs, ThatEndAtAnyPointCostNoRead) {
    for (const char* how : {"closes after the greeting", "closes when it is asked"})
        expect_right_by_files(job(how));
}

TEST_F(BadJobs, ThatSayWhatCannotBeCostNoRead) {
    for (const char* how :
         {"brings what nobody asked for", "answers twice", "cuts an answer off", "holds nothing"})
        expect_right_by_files(job(how));
}

TEST_F(BadJobs, ThatBringDamagedBricksOrOthersCostNoRead) {
    for (const char* how : {"has no checksum", "brings another brick"}) {
        RankedStore store(reader_, job(how));
        store.ranks().begin();
        ASSERT_TRUE(store.ranks().wait_for_job(1, at_most));
        EXPECT_EQ(all_bricks(*store.bricks()), bytes_);
        EXPECT_EQ(store.ranks().status().damaged, bricks_in_all);
    }
}

TEST_F(BadJobs, ThatSayNothingKeepReadsForNoLongerThanTheirPatience) {
    RankBricks::Options options = job("says nothing");
    options.patience = 20ms;
    expect_right_by_files(options);
}

TEST_F(BadJobs, ThatHangAreEndedAndStartedAgain) {
    RankBricks::Options options = job("says nothing");
    options.patience = options.hung = 20ms;
    RankedStore store(reader_, options);
    store.ranks().begin();
    ASSERT_TRUE(store.ranks().wait_for_job(1, at_most));
    EXPECT_EQ(all_bricks(*store.bricks()), bytes_);
    EXPECT_TRUE(store.ranks().wait_for_job(2, at_most));
}

TEST_F(BadJobs, ThatCannotBeStartedOrNeverComeCostNoRead) {
    RankBricks::Options none = job("stays away");
    none.words = {"/no/such/program"};
    for (RankBricks::Options options : {none, job("stays away")}) {
        options.coming = 1ms;
        RankedStore store(reader_, options);
        store.ranks().begin();
        EXPECT_EQ(all_bricks(*store.bricks()), bytes_);
        EXPECT_EQ(store.ranks().status().jobs, 0u);
    }
}

TEST_F(BadJobs, AreToldOfByReadsThatEndWithTheSource) {
    RankBricks::Options options = job("says nothing");
    std::vector<float> room(bricks_in_all * hello.shape.values);
    std::vector<core::BrickRead> reads;
    for (std::size_t i = 0; i < bricks_in_all; ++i)
        reads.push_back({i / bricks_a_step, i % bricks_a_step,
                         std::span(room).subspan(i * hello.shape.values, hello.shape.values)});
    std::atomic<std::size_t> cancelled = 0;
    {
        RankedStore store(reader_, options);
        store.ranks().begin();
        ASSERT_TRUE(store.ranks().wait_for_job(1, at_most));
        store.bricks()->read(reads, {}, [&](std::size_t, const core::Result<void>& outcome) {
            cancelled += !outcome && outcome.error().code == core::Error::Code::Cancelled;
        });
    }
    EXPECT_EQ(cancelled, bricks_in_all);
}

TEST_F(BadJobs, DoNotChangeWhatIsSaidOfBricksThatThereAreNot) {
    RankedStore store(reader_, job("holds nothing"));
    store.ranks().begin();
    ASSERT_TRUE(store.ranks().wait_for_job(1, at_most));
    std::vector<float> room(hello.shape.values);
    const auto outcomes = outcomes_of(*store.bricks(), {{0, bricks_a_step, room}, {4, 0, room}});
    for (const auto& each : outcomes)
        EXPECT_EQ(each.error().code, core::Error::Code::NotFound);
}

TEST(LocalDoor, IsThisUsersAloneAndGoesWithItsFolder) {
    std::filesystem::path path;
    {
        const LocalDoor door = LocalDoor::open().value();
        path = door.path();

        struct stat file {
        }, folder{};

        ASSERT_EQ(::stat(path.c_str(), &file), 0);
        ASSERT_EQ(::stat(path.parent_path().c_str(), &folder), 0);
        EXPECT_EQ(file.st_mode & 0777u, 0600u);
        EXPECT_EQ(folder.st_mode & 0777u, 0700u);
    }
    EXPECT_FALSE(std::filesystem::exists(path.parent_path()));
}

TEST(ProgramWords, AreSplitAtBlanksButForQuotes) {
    const std::vector<std::string> words{"srun", "--mpi=pmix", "-n", "4", "--comment", "a b"};
    EXPECT_EQ(program_words(" srun --mpi=pmix  -n 4 --comment \"a b\" ").value(), words);
    EXPECT_EQ(program_words("a $HOME;*").value(), (std::vector<std::string>{"a", "$HOME;*"}));
    EXPECT_FALSE(program_words("  "));
}

} // namespace wakesurf::server::bad_jobs_test
