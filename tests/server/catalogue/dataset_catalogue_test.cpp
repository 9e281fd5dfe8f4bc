#include "server/catalogue/dataset_catalogue.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <set>

namespace wakesurf::server {
namespace {

using namespace tests;

// A catalogue and a way to wait for what its import thread tells.
class Bench {
  public:
    explicit Bench(const std::vector<std::string>& arguments) {
        OpenOptions options{folder_ / "cache", {}, WAKESURF_IMPORT_BINARY};
        auto opened = DatasetCatalogue::open(arguments, options, [this](const std::string&) {
            const std::scoped_lock lock(mutex_);
            ++changes_;
            changed_.notify_all();
        });
        if (opened)
            catalogue = std::move(*opened);
        else
            error = opened.error();
    }

    ~Bench() { catalogue.reset(); }

    DatasetStatus wait_until_settled(const std::string& dataset) {
        std::unique_lock lock(mutex_);
        DatasetStatus status;
        changed_.wait(lock, [&] {
            status = catalogue->status(dataset).value();
            return status.state != DatasetState::Importing;
        });
        return status;
    }

    std::unique_ptr<DatasetCatalogue> catalogue;
    std::optional<core::Error> error;

  private:
    TemporaryFolder folder_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int changes_ = 0;
};

const std::string bundled = std::string(WAKESURF_SOURCE_DIR) + "/data/sqcyl";

TEST(DatasetCatalogue, ImportsASourceAndOpensIt) {
    Bench bench({bundled});
    const auto status = bench.wait_until_settled("sqcyl");
    ASSERT_EQ(status.state, DatasetState::Ready) << status.error.value_or(core::Error{}).message;
    EXPECT_EQ(status.steps_ready, 16u);
    EXPECT_EQ(status.steps_total, 16u);
    const auto open = bench.catalogue->find("sqcyl").value();
    EXPECT_EQ(open->info.dataset, "sqcyl");
    EXPECT_GT(open->info.fields.at(0).range[1], 1.78); // over all time-steps, not only the first
    EXPECT_FALSE(open->store->mask().empty());
    EXPECT_EQ(open->flow->domain().hi, open->info.bounds.hi);
    EXPECT_EQ(open->cache->acquire(15).value()->time, 16.0);
}

TEST(DatasetCatalogue, KeepsADatasetThatCannotBeImportedWithTheReason) {
    const TemporaryFolder folder;
    write_file(folder / "bad.vti", "nonsense");
    Bench bench({"flow:abc", folder / "bad.vti", bundled});
    const auto bad = bench.wait_until_settled("bad");
    EXPECT_EQ(bad.state, DatasetState::Failed);
    ASSERT_TRUE(bad.error.has_value());
    EXPECT_NE(bad.error->message.find("bad.vti"), std::string::npos) << bad.error->message;
    EXPECT_EQ(bad.error->message.find(folder.path()), std::string::npos) << bad.error->message;
    EXPECT_EQ(bench.catalogue->find("bad").error().message, bad.error->message);
    EXPECT_EQ(bench.wait_until_settled("sqcyl").state, DatasetState::Ready); // the others go on
    EXPECT_EQ(bench.catalogue->list().size(), 3u);
}

TEST(DatasetCatalogue, GivesEveryDatasetAnIdOfItsOwn) {
    Bench bench({"flow:abc", "flow:abc?A=2", "flow:abc"});
    ASSERT_NE(bench.catalogue, nullptr) << bench.error->message;
    std::set<std::string> ids;
    for (const auto& status : bench.catalogue->list()) {
        EXPECT_EQ(status.state, DatasetState::Ready);
        EXPECT_EQ(bench.catalogue->find(status.dataset).value()->info.dataset, status.dataset);
        ids.insert(status.dataset);
    }
    EXPECT_EQ(ids.size(), 3u);
}

TEST(DatasetCatalogue, SaysAtOnceWhatIsMistyped) {
    EXPECT_EQ(Bench({"flow:nothing"}).error->code, core::Error::Code::NotFound);
    EXPECT_EQ(Bench({"/no/such/file.pvd"}).error->code, core::Error::Code::NotFound);
    Bench bench({"flow:abc"});
    EXPECT_EQ(bench.catalogue->find("xyz").error().code, core::Error::Code::NotFound);
    EXPECT_EQ(bench.catalogue->status("xyz").error().code, core::Error::Code::NotFound);
}

TEST(DatasetCatalogue, EndsWhileItImports) {
    Bench bench({bundled});
    (void)bench.catalogue->list();
}

} // namespace
} // namespace wakesurf::server
