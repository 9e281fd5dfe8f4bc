#include "core/base/disk.hpp"
#include "store/store_generation.hpp"
#include "store/store_manifest.hpp"
#include "tests/server/data/catalogue_bench.hpp"
#include "tests/support/places.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/slow_series.hpp"
#include "tests/support/vti_text.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <new>
#include <random>
#include <set>
#include <thread>

namespace wakesurf::server::dataset_catalogue_test {
namespace {

using namespace tests;

using Bench = CatalogueBench;

const std::string bundled = (source_folder() / "data/sqcyl").string();

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

/// A program that tells this progress in the importer's place, and does not end until it is stopped.
std::filesystem::path telling(const TemporaryFolder& folder,
                              const store::ImportProgress& progress) {
    const auto program = folder / "importer";
    write_file(program, "#!/bin/sh\necho '" + store::progress_line(progress) +
                            "'\nexec tail -f /dev/null\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return program;
}

TEST(DatasetCatalogue, WhatAnEarlierRunImportedCanBeUsedOnceItsTimeStepsAreCounted) {
    const TemporaryFolder folder;
    Bench({bundled}, folder / "stores").wait_until_settled("sqcyl");
    Bench bench({bundled}, folder / "stores", telling(folder, {"done", 16, 16, {}, {}}));
    const auto status =
        bench.wait_until("sqcyl", [](const DatasetStatus& each) { return each.steps_ready > 0; });
    EXPECT_EQ(status.state, DatasetState::Importing) << "its importer has not ended";
    EXPECT_EQ(status.steps_ready, 16u);
    const auto open = bench.catalogue->find("sqcyl");
    ASSERT_TRUE(open.has_value()) << open.error().message;
    EXPECT_EQ((*open)->cache->acquire(15).value()->time, 16.0);
}

TEST(DatasetCatalogue, CountsNoTimeStepOfAStoreThatCannotBeOpened) {
    const TemporaryFolder folder;
    Bench bench({bundled}, folder / "stores", telling(folder, {"import", 4, 16, {}, {}}));
    const auto status =
        bench.wait_until("sqcyl", [](const DatasetStatus& each) { return each.steps_total > 0; });
    EXPECT_EQ(status.steps_total, 16u);
    EXPECT_EQ(status.steps_ready, 0u);
    EXPECT_EQ(bench.catalogue->find("sqcyl").error().message,
              "sqcyl has no time-step imported yet");
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

TEST(DatasetCatalogue, ADatasetWhoseOpeningThrowsFailsAloneAndIsOpenedOnceItCanBe) {
    const TemporaryFolder folder;
    const store::GenerateRequest small{
        .flow = "abc", .grid = {{0, 0, 0}, {1, 1, 1}, {9, 9, 9}}, .times = {0.0}};
    ASSERT_TRUE(
        store::generate_store(small, folder / "small", [](const store::ImportProgress&) {}, {}));
    const core::MemoryAccount account(std::size_t{64} << 20);
    auto all = account.open(core::MemoryUse::Other);
    all.set(account.budget());
    auto asked =
        account.on_need(core::ReclaimOrder::TimeSteps, [](std::size_t) { throw std::bad_alloc(); });
    OpenOptions options;
    options.store_root = folder / "cache";
    options.cache.account = account;
    Bench bench({"flow:abc", folder / "small"}, options);
    const auto failed = bench.wait_until_settled("small");
    EXPECT_EQ(failed.state, DatasetState::Failed);
    ASSERT_TRUE(failed.error.has_value());
    EXPECT_EQ(failed.error->code, core::Error::Code::OverLimit);
    EXPECT_EQ(failed.error->message, "there is not enough memory to open the dataset");
    EXPECT_TRUE(bench.catalogue->find("abc"));
    asked.reset();
    all.shrink_to(0);
    bench.wait_until("small",
                     [](const DatasetStatus& now) { return now.state == DatasetState::Ready; });
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

/// What was imported, down to the bytes.
std::map<std::string, std::uint32_t> imported(const Bench& bench, const std::string& dataset) {
    return bench.catalogue->find(dataset).value()->store->layout().checksums;
}

TEST(DatasetCatalogue, AnImportThatIsStoppedKeepsWhatItHasAndGoesOnFromThere) {
    const TemporaryFolder folder;
    const auto source = write_slow_series(folder.path());
    Bench bench({source});
    const auto begun = bench.wait_until(
        "u_00", [](const DatasetStatus& status) { return status.steps_ready > 0; });
    ASSERT_EQ(begun.state, DatasetState::Importing);
    const auto first = bench.catalogue->find("u_00").value();
    EXPECT_TRUE(bench.catalogue->stop_import("u_00"));
    const auto stopped = bench.catalogue->status("u_00").value();
    EXPECT_EQ(stopped.state, DatasetState::Stopped);
    EXPECT_LT(stopped.steps_ready, stopped.steps_total);
    EXPECT_FALSE(bench.catalogue->stop_import("u_00"));
    EXPECT_TRUE(bench.tidies_up());
    // Once what there is has been opened anew:
    const auto later = bench.wait_until("u_00", [&](const DatasetStatus&) {
        return bench.catalogue->find("u_00").value() != first;
    });
    EXPECT_EQ(later.state, DatasetState::Stopped);
    EXPECT_LT(later.progress, 1.0);
    EXPECT_NEAR(later.progress, static_cast<double>(later.steps_ready) / 40.0, 1e-12);
    const auto open = bench.catalogue->find("u_00").value();
    EXPECT_EQ(open->cache->acquire(0).value()->velocity()[0], 0.5f);
    EXPECT_TRUE(bench.catalogue->start_import("u_00"));
    EXPECT_FALSE(bench.catalogue->start_import("u_00"));
    const auto ready = bench.wait_until_settled("u_00");
    EXPECT_EQ(ready.state, DatasetState::Ready);
    EXPECT_EQ(ready.steps_ready, 40u);
    Bench twin({source});
    twin.wait_until_settled("u_00");
    EXPECT_EQ(imported(bench, "u_00"), imported(twin, "u_00"));
}

TEST(DatasetCatalogue, AnImportThatWaitsForItsTurnIsStoppedToo) {
    const TemporaryFolder folder;
    Bench bench({write_slow_series(folder.path()), bundled}, {}, importer_program(), 1);
    EXPECT_TRUE(bench.catalogue->stop_import("sqcyl"));
    EXPECT_TRUE(bench.catalogue->stop_import("u_00"));
    EXPECT_EQ(bench.catalogue->find("sqcyl").error().message,
              "the import of sqcyl was stopped before its first time-step");
    EXPECT_TRUE(bench.catalogue->start_import("sqcyl"));
    EXPECT_EQ(bench.wait_until_settled("sqcyl").state, DatasetState::Ready);
    EXPECT_EQ(bench.catalogue->status("u_00")->state, DatasetState::Stopped);
}

TEST(DatasetCatalogue, WhatAnEarlierRunImportedIsThereThoughItsTurnWasStopped) {
    const TemporaryFolder folder;
    const auto stores = folder / "stores";
    Bench({bundled}, stores).wait_until_settled("sqcyl");
    Bench bench({write_slow_series(folder.path()), bundled}, stores, importer_program(), 1);
    ASSERT_TRUE(bench.catalogue->stop_import("sqcyl"));
    ASSERT_TRUE(bench.catalogue->stop_import("u_00")); // its turn comes
    const auto status =
        bench.wait_until("sqcyl", [](const DatasetStatus& each) { return each.steps_ready > 0; });
    EXPECT_EQ(status.state, DatasetState::Stopped);
    EXPECT_EQ(status.steps_ready, 16u);
    EXPECT_EQ(bench.catalogue->find("sqcyl").value()->cache->acquire(15).value()->time, 16.0);
}

TEST(DatasetCatalogue, OnlyAnImportCanBeStoppedAndOnlyAStoppedOneStarted) {
    Bench bench({"flow:abc", bundled});
    bench.wait_until_settled("sqcyl");
    for (const char* dataset : {"abc", "sqcyl", "nothing"}) {
        EXPECT_FALSE(bench.catalogue->stop_import(dataset)) << dataset;
        EXPECT_FALSE(bench.catalogue->start_import(dataset)) << dataset;
    }
}

TEST(DatasetCatalogue, StoppedAndStartedAtAnyMomentAnImportComesToTheSame) {
    const TemporaryFolder folder;
    const auto source = write_slow_series(folder.path(), 12);
    Bench twin({source});
    twin.wait_until_settled("u_00");
    std::size_t stops = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        std::mt19937 random(seed);
        Bench bench({source});
        for (int i = 0; i < 12; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(random() % 40));
            stops += bench.catalogue->stop_import("u_00") ? 1 : 0;
            std::this_thread::sleep_for(std::chrono::milliseconds(random() % 2 * (random() % 40)));
            bench.catalogue->start_import("u_00");
        }
        EXPECT_EQ(bench.wait_until_settled("u_00").state, DatasetState::Ready);
        EXPECT_EQ(imported(bench, "u_00"), imported(twin, "u_00")) << "seed " << seed;
        EXPECT_TRUE(bench.tidies_up());
    }
    EXPECT_GT(stops, 4u);
}

bool has_child_processes() {
    siginfo_t ignored{};
    return waitid(P_ALL, 0, &ignored, WEXITED | WNOHANG | WNOWAIT) == 0;
}

TEST(DatasetCatalogue, EndsTheImportThatIsRunningWhenItGoes) {
    const TemporaryFolder folder;
    const auto source = write_slow_series(folder.path());
    Bench bench({source}, folder / "stores");
    const auto amid = bench.wait_until(
        "u_00", [](const DatasetStatus& status) { return status.steps_ready > 0; });
    ASSERT_EQ(amid.state, DatasetState::Importing);
    ASSERT_TRUE(has_child_processes());
    bench.catalogue.reset();
    EXPECT_FALSE(has_child_processes());
    EXPECT_EQ(unfinished_files(folder / "stores"), 0u);
    std::size_t manifests = 0;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder / "stores"))
        if (each.path().filename() == store::manifest_file_name) {
            ++manifests;
            const auto kept =
                store::read_store_manifest(each.path().parent_path(), core::PosixDisk());
            EXPECT_FALSE(kept.value().complete) << "it was waited for";
        }
    EXPECT_EQ(manifests, 1u);
}

TEST(DatasetCatalogue, NoticesTheTimeStepsOfARunningSimulation) {
    const TemporaryFolder folder;
    write_file(folder / "u_0.vti", sample_vti(0.0).text());
    write_file(folder / "u_1.vti", sample_vti(1.0).text());
    Bench bench({folder / "u_0.vti"});
    bench.wait_until_settled("u_0");
    const auto before = bench.catalogue->find("u_0").value();
    ASSERT_EQ(before->info.times.size(), 2u);
    write_file(folder / "u_2.vti", sample_vti(2.0).text());
    bench.wait_until("u_0", [](const DatasetStatus& status) { return status.steps_ready == 3; });
    const auto after = bench.catalogue->find("u_0").value();
    EXPECT_EQ(after->info.times, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(after->cache->acquire(2).value()->velocity()[0], 2.0f);
    EXPECT_EQ(before->info.times.size(), 2u); // who holds the old one keeps it
    EXPECT_EQ(before->cache->acquire(1).value()->velocity()[0], 1.0f);
}

TEST(DatasetCatalogue, TakesATimeStepThatIsStillBeingWrittenOnceItIsWhole) {
    const TemporaryFolder folder;
    const std::string whole = sample_vti(1.0).text();
    write_file(folder / "u_0.vti", sample_vti(0.0).text());
    write_file(folder / "u_1.vti", whole.substr(0, whole.size() / 2));
    Bench bench({folder / "u_0.vti"});
    const auto partly = bench.wait_until(
        "u_0", [](const DatasetStatus& status) { return status.error.has_value(); });
    EXPECT_EQ(partly.state, DatasetState::Incomplete) << "1 of 2";
    EXPECT_FALSE(partly.error->hint.empty());
    EXPECT_NE(partly.error->message.find("u_1.vti"), std::string::npos) << partly.error->message;
    EXPECT_TRUE(bench.catalogue->find("u_0").value()->cache->acquire(0).has_value());
    Bench later({folder / "u_0.vti"}, folder / "stores");
    later.wait_until("u_0", [](const DatasetStatus& status) { return status.error.has_value(); });
    Bench again({folder / "u_0.vti"}, folder / "stores");
    const auto still = again.wait_until(
        "u_0", [](const DatasetStatus& status) { return status.error.has_value(); });
    EXPECT_EQ(still.state, DatasetState::Incomplete) << "though nothing was converted";
    EXPECT_EQ(still.steps_ready, 1u);
    write_file(folder / "u_1.vti", whole);
    const auto complete = bench.wait_until("u_0", [](const DatasetStatus& status) {
        return !status.error && status.steps_ready == 2;
    });
    EXPECT_EQ(complete.state, DatasetState::Ready);
    EXPECT_EQ(bench.catalogue->find("u_0").value()->cache->acquire(1).value()->velocity()[0], 1.0f);
}

TEST(DatasetCatalogue, AStoreWithoutItsLastTimeStepsIsIncompleteAndSaysWhatToDo) {
    const TemporaryFolder folder;
    write_file(folder / "u_0.vti", sample_vti(0.0).text());
    write_file(folder / "u_1.vti", "nonsense");
    ImportCommand import{folder / "u_0.vti", folder / "store", {}, {}, importer_program()};
    import.growing = true;
    ASSERT_FALSE(run_import_process(import, [](const store::ImportProgress&) {}));
    Bench bench({folder / "store"});
    const auto status = bench.wait_until_settled("store");
    EXPECT_EQ(status.state, DatasetState::Incomplete);
    EXPECT_EQ(status.steps_ready, 1u);
    EXPECT_EQ(status.steps_total, 2u);
    ASSERT_TRUE(status.error.has_value());
    EXPECT_NE(status.error->message.find("1 of 2"), std::string::npos) << status.error->message;
    EXPECT_NE(status.error->hint.find("import"), std::string::npos);
    EXPECT_TRUE(bench.catalogue->find("store").has_value()) << "what is there can be used";
}

// Everybody with a link may ask for the error, and a library quotes what it cannot use, of any file.
TEST(DatasetCatalogue, TellsNoWordsOfLibraries) {
    const TemporaryFolder folder;
    write_file(folder / "u.vtk", "# vtk DataFile Version 3.0\nu\nASCII\nDATASET STRUCTURED_POINTS\n"
                                 "DIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8\n"
                                 "VECTORS U frobnicate\n1 0 0\n");
    Bench bench({folder / "u.vtk"});
    const auto status = bench.wait_until_settled("u");
    ASSERT_EQ(status.state, DatasetState::Failed);
    EXPECT_EQ(status.error->message,
              "u.vtk is damaged, or not the kind of file that it claims to be");
}

TEST(DatasetCatalogue, AFailedSourceThatIsImportedAgainIsUsableFromItsFirstTimeStep) {
    const TemporaryFolder folder;
    const auto source = write_slow_series(folder.path());
    const auto good = folder / "good";
    std::filesystem::rename(source, good);
    write_file(source, "nonsense");
    Bench bench({source});
    ASSERT_EQ(bench.wait_until_settled("u_00").state, DatasetState::Failed);
    std::filesystem::rename(good, source);
    const auto begun = bench.wait_until(
        "u_00", [](const DatasetStatus& status) { return status.steps_ready > 0; });
    EXPECT_LT(begun.steps_ready, 40u);
    const auto open = bench.catalogue->find("u_00");
    ASSERT_TRUE(open.has_value()) << open.error().message;
    EXPECT_EQ((*open)->cache->acquire(0).value()->velocity()[0], 0.5f);
    const auto ready = bench.wait_until(
        "u_00", [](const DatasetStatus& status) { return status.state == DatasetState::Ready; });
    EXPECT_EQ(ready.steps_ready, 40u);
    EXPECT_FALSE(ready.error.has_value());
}

/// u_0.vti, ... of these velocities; the first file.
std::filesystem::path write_series(const TemporaryFolder& folder,
                                   const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        write_file(folder / ("u_" + std::to_string(i) + ".vti"), sample_vti(values[i]).text());
    return folder / "u_0.vti";
}

float value_of(const Bench& bench, std::size_t step) {
    const auto open = bench.catalogue->find("u_0");
    const auto got = open ? (*open)->cache->acquire(step) : tl::unexpected(open.error());
    return got ? (*got)->velocity()[0] : -1.0f;
}

TEST(DatasetCatalogue, DataComputedAgainIntoTheSameFilesAreOpenedAnew) {
    for (const auto& again : std::vector<std::vector<double>>{{5, 6, 7}, {0, 6, 2}, {0, 1, 7}}) {
        const TemporaryFolder folder;
        Bench bench({write_series(folder, {0, 1, 2})});
        const auto first = bench.wait_until_settled("u_0");
        for (const std::size_t step : {0, 1, 2}) // in memory
            ASSERT_EQ(value_of(bench, step), static_cast<float>(step));
        const auto before = bench.catalogue->find("u_0").value();
        write_series(folder, again);
        bench.wait_until("u_0", [&](const DatasetStatus& status) {
            return status.state == DatasetState::Ready && status.values != first.values;
        });
        EXPECT_FALSE(
            bench.catalogue->find("u_0").value()->store->marks().continues(before->store->marks()));
        for (const std::size_t step : {0, 1, 2})
            EXPECT_EQ(value_of(bench, step), static_cast<float>(again[step])) << step;
    }
}

TEST(DatasetCatalogue, AnotherGridWithTheSameTimesIsAnotherDataset) {
    const TemporaryFolder folder;
    Bench bench({write_series(folder, {1, 1})});
    const auto first = bench.wait_until_settled("u_0");
    ASSERT_EQ(value_of(bench, 1), 1.0f);
    for (const int step : {0, 1}) {
        VtiText other = sample_vti(1.0);
        other.origin = "7 7 7";
        write_file(folder / ("u_" + std::to_string(step) + ".vti"), other.text());
    }
    bench.wait_until("u_0", [&](const DatasetStatus& status) {
        return status.state == DatasetState::Ready && status.values != first.values;
    });
    const auto open = bench.catalogue->find("u_0").value();
    EXPECT_EQ(open->info.bounds.lo.x, 7.0);
    EXPECT_EQ(open->flow->domain().lo.x, 7.0);
}

TEST(DatasetCatalogue, AStoreThatIsReplacedIsOpenedAnewAndOneThatIsGoneStays) {
    const TemporaryFolder folder;
    const auto import = [&](double value, const char* store) {
        const TemporaryFolder source;
        const ImportCommand command{
            write_series(source, {value, value}), folder / store, {}, {}, importer_program()};
        ASSERT_TRUE(run_import_process(command, [](const store::ImportProgress&) {}).has_value());
    };
    import(1, "u_0");
    import(2, "other");
    Bench bench({folder / "u_0"});
    const auto first = bench.wait_until_settled("u_0");
    ASSERT_EQ(value_of(bench, 0), 1.0f);
    std::filesystem::rename(folder / "u_0", folder / "old");
    bench.wait_until("u_0", [](const DatasetStatus& status) { return status.error.has_value(); });
    EXPECT_EQ(value_of(bench, 0), 1.0f);
    std::filesystem::rename(folder / "other", folder / "u_0");
    bench.wait_until("u_0", [&](const DatasetStatus& status) {
        return !status.error && status.values != first.values;
    });
    EXPECT_EQ(value_of(bench, 0), 2.0f);
}

TEST(DatasetCatalogue, WhatCouldNotBeImportedAgainIsNotShownAsBefore) {
    const TemporaryFolder folder;
    Bench bench({write_series(folder, {1, 1})});
    bench.wait_until_settled("u_0");
    ASSERT_EQ(value_of(bench, 1), 1.0f);
    write_file(folder / "u_1.vti", "nonsense");
    write_file(folder / "u_0.vti", sample_vti(5).text());
    const auto status = bench.wait_until("u_0", [](const DatasetStatus& each) {
        return each.state == DatasetState::Incomplete && each.error.has_value();
    });
    EXPECT_EQ(status.steps_ready, 1u);
    EXPECT_EQ(value_of(bench, 0), 5.0f);
    EXPECT_EQ(value_of(bench, 1), -1.0f);
}

TEST(DatasetCatalogue, ASlowImportKeepsNoOtherWaiting) {
    const TemporaryFolder folder;
    Bench bench({write_slow_series(folder.path(), 400), bundled});
    EXPECT_EQ(bench.wait_until_settled("sqcyl").state, DatasetState::Ready);
    EXPECT_EQ(bench.catalogue->status("u_00")->state, DatasetState::Importing);
}

} // namespace
} // namespace wakesurf::server::dataset_catalogue_test
