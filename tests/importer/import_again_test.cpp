// Imports into a store that is there: finished, interrupted, damaged, of a source that changed or grew.
#include "tests/importer/import_fixture.hpp"
#include "tests/support/mask_bytes.hpp"
#include "tests/support/programs.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace wakesurf::importer::import_again_test {
namespace {

TEST_F(Import, DoesNotRepeatAFinishedImport) {
    put("a.vti", sample_vti(1).text());
    ASSERT_EQ(run("a.vti").status, 0);
    const auto before = core::PosixDisk().identity(store() / "velocity_000000.f32").value();
    const auto again = run("a.vti");
    ASSERT_EQ(again.status, 0);
    EXPECT_EQ(again.lines.size(), 1u);
    EXPECT_EQ(core::PosixDisk().identity(store() / "velocity_000000.f32").value(), before);
}

TEST_F(Import, RepeatsTheImportOfAChangedSource) {
    put("a.vti", sample_vti(1).text());
    ASSERT_EQ(run("a.vti").status, 0);
    EXPECT_EQ(velocity(0)[0], 1.0f);
    put("a.vti", sample_vti(2).text()); // same size, other time of change
    ASSERT_EQ(run("a.vti").status, 0);
    EXPECT_EQ(velocity(0)[0], 2.0f);
}

// As while a solver writes it again.
TEST_F(Import, LeavesAStoreAsItIsWhereNothingCanBeReadOfTheChangedSource) {
    put("a.vti", sample_vti(1).text());
    ASSERT_EQ(run("a.vti").status, 0);
    const auto whole = sample_vti(2).text();
    for (const std::size_t cut : {std::size_t{0}, whole.size() / 2, whole.size() - 30}) {
        put("a.vti", whole.substr(0, cut));
        EXPECT_EQ(run("a.vti").status, 1) << cut;
        EXPECT_TRUE(manifest().complete) << cut;
        EXPECT_EQ(velocity(0)[0], 1.0f) << cut;
    }
    auto bad = sample_vti(2);
    bad.points = vti_array("U", 2, bad.point_count(), [](std::size_t) { return 1.0; });
    put("a.vti", bad.text());
    EXPECT_EQ(run("a.vti").status, 1);
    EXPECT_EQ(velocity(0)[0], 1.0f);
    put("a.vti", whole);
    ASSERT_EQ(run("a.vti").status, 0);
    EXPECT_EQ(velocity(0)[0], 2.0f);
}

TEST_F(Import, RepeatsTheImportForAnotherSelection) {
    put("s.pvd", pvd_text({{"0", "a.vti"}, {"1", "b.vti"}, {"2", "c.vti"}}));
    for (const char* name : {"a", "b", "c"})
        put(std::string(name) + ".vti", sample_vti(name[0] - 'a').text());
    ASSERT_EQ(run("s.pvd").status, 0);
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{0, 1, 2}));
    ASSERT_EQ(run("s.pvd", {"--times", "0:2:2"}).status, 0);
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{0, 2}));
    EXPECT_EQ(velocity(1)[0], 2.0f);
    EXPECT_FALSE(fs::exists(store() / "velocity_000002.f32"));
}

TEST_F(Import, LaysTimeStepsInBricksWithTheSameValuesAndGoesOnSo) {
    ASSERT_EQ(import({bundled, store(), "--jobs", "2"}).status, 0);
    const auto whole = reader();
    std::vector<std::shared_ptr<const core::TimeStep>> before;
    for (std::size_t step = 0; step < whole->times().size(); ++step)
        before.push_back(whole->load(step, {}).value());
    ASSERT_EQ(import({bundled, store(), "--layout", "bricks", "--jobs", "2"}).status, 0);
    EXPECT_EQ(manifest().layout.brick_cells, 32u);
    const auto bricks = reader();
    const std::size_t nodes = core::node_count(whole->grid());
    EXPECT_EQ(tests::mask_bytes(bricks->mask(), nodes), tests::mask_bytes(whole->mask(), nodes));
    for (std::size_t step = 0; step < before.size(); ++step)
        EXPECT_TRUE(std::ranges::equal(bricks->load(step, {}).value()->slab.bytes(),
                                       before[step]->slab.bytes()))
            << step;
    // Damaged, it is mended; without --layout it stays in bricks.
    const auto good = read_file(store() / "velocity_000003.bricks");
    fs::resize_file(store() / "velocity_000003.bricks", 4);
    std::fstream(store() / "velocity_000005.f32").put('x');
    const auto kept = core::PosixDisk().identity(store() / "velocity_000004.f32").value();
    ASSERT_EQ(import({bundled, store()}).status, 0);
    EXPECT_EQ(manifest().layout.brick_cells, 32u);
    EXPECT_EQ(read_file(store() / "velocity_000003.bricks"), good);
    EXPECT_TRUE(reader()->load(5, {}));
    EXPECT_EQ(core::PosixDisk().identity(store() / "velocity_000004.f32").value(), kept);
    EXPECT_EQ(import({bundled, store()}).lines.size(), 1u) << "up to date";
    ASSERT_EQ(import({bundled, store(), "--layout", "whole"}).status, 0);
    EXPECT_FALSE(fs::exists(store() / "velocity_000003.bricks"));
    EXPECT_EQ(manifest().layout.brick_cells, 0u);
}

TEST_F(Import, LaysScalarsInBricksToo) {
    auto vti = sample_vti(1);
    vti.points += vti_array("p", 1, vti.point_count(),
                            [](std::size_t i) { return 0.5 * static_cast<double>(i); });
    put("a.vti", vti.text());
    ASSERT_EQ(run("a.vti").status, 0);
    const auto whole = reader()->load_scalar(0, 0, {}).value();
    ASSERT_EQ(run("a.vti", {"--layout", "bricks"}).status, 0);
    EXPECT_TRUE(fs::exists(store() / "p_000000.bricks"));
    EXPECT_TRUE(std::ranges::equal(reader()->load_scalar(0, 0, {}).value().bytes(), whole.bytes()));
}

TEST_F(Import, RefusesBricksOfAMeshOfCells) {
    put("a.vtk", "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                 "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\n"
                 "CELL_TYPES 1\n10\nPOINT_DATA 4\nVECTORS U float\n"
                 "1 0 0 1 0 0 1 0 0 1 0 0\n");
    ASSERT_EQ(run("a.vtk").status, 0);
    const auto refused = run("a.vtk", {"--layout", "bricks"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.errors.find("only uniform and rectilinear grids lie in bricks"),
              std::string::npos)
        << refused.errors;
    EXPECT_TRUE(manifest().complete) << "what was there stays";
}

TEST_F(Import, MendsAStoreWithADamagedStep) {
    ASSERT_EQ(import({bundled, store()}).status, 0);
    const auto good = read_file(store() / "velocity_000003.f32");
    fs::resize_file(store() / "velocity_000003.f32", 100);
    fs::remove(store() / "velocity_000007.f32");
    std::fstream(store() / "velocity_000009.f32").put('x');
    const auto kept = core::PosixDisk().identity(store() / "velocity_000004.f32").value();
    ASSERT_EQ(import({bundled, store()}).status, 0);
    EXPECT_TRUE(read_file(store() / "velocity_000003.f32") == good);
    EXPECT_TRUE(reader()->load(7, {}) && reader()->load(9, {}));
    EXPECT_EQ(core::PosixDisk().identity(store() / "velocity_000004.f32").value(), kept);
}

TEST_F(Import, GoesOnAfterItWasKilled) {
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    const std::string source = bundled;
    const std::string target = store();
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::execl(tests::importer_program().c_str(), "wakesurf-import", source.c_str(),
                target.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    char first = 0;
    ASSERT_EQ(::read(ends[0], &first, 1), 1); // the first time-step is written
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ::close(ends[0]);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_FALSE(manifest().complete);
    EXPECT_TRUE(reader()->ready(0)); // usable as it is
    for (const auto& entry : fs::directory_iterator(store()))
        EXPECT_TRUE(entry.path().extension() != ".f32" ||
                    entry.file_size() == manifest().info.bytes_per_step)
            << entry.path();
    const auto kept = core::PosixDisk().identity(store() / "velocity_000000.f32").value();
    ASSERT_EQ(import({bundled, store()}).status, 0);
    EXPECT_EQ(core::PosixDisk().identity(store() / "velocity_000000.f32").value(), kept);
    const fs::path fresh = folder_ / "fresh";
    ASSERT_EQ(import({bundled, fresh}).status, 0);
    for (const auto& entry : fs::directory_iterator(fresh))
        EXPECT_EQ(read_file(entry.path()), read_file(store() / entry.path().filename().string()))
            << entry.path();
}

TEST_F(Import, LeavesOnlyWholeFilesWhenInterrupted) {
    std::stop_source stop;
    const auto outcome = run_import_process(
        {bundled, store(), {}, {}, tests::importer_program()},
        [&](const store::ImportProgress& progress) {
            if (progress.done == 2)
                stop.request_stop();
        },
        stop.get_token());
    EXPECT_EQ(outcome.error().code, core::Error::Code::Cancelled);
    for (const auto& entry : fs::directory_iterator(store()))
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    EXPECT_TRUE(reader()->ready(1));
}

TEST_F(Import, WaitsForAnotherImporterOfTheSameStore) {
    fs::create_directory(store());
    const int lock = ::open((store() / "store.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    ASSERT_EQ(::flock(lock, LOCK_EX), 0);
    put("a.vti", sample_vti(1).text());
    std::vector<std::string> phases;
    const auto outcome =
        run_import_process({folder_ / "a.vti", store(), {}, {}, tests::importer_program()},
                           [&](const store::ImportProgress& progress) {
                               phases.push_back(progress.phase);
                               if (progress.phase == "waiting")
                                   ::close(lock);
                           });
    ASSERT_TRUE(outcome.has_value()) << outcome.error().message;
    EXPECT_EQ(phases, (std::vector<std::string>{"waiting", "import", "done"}));
}

TEST_F(Import, DoesNotTouchAFolderWithOtherThingsInIt) {
    fs::create_directory(store());
    write_file(store() / "thesis.tex", "years of work");
    put("a.vti", sample_vti().text());
    expect_refusal("a.vti", "thesis.tex");
}

} // namespace
} // namespace wakesurf::importer::import_again_test
