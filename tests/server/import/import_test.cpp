// wakesurf-import as a process: what it makes of good sources, bad ones, and of being interrupted.
#include "core/dataset/store_reader.hpp"
#include "protocol/store_manifest.hpp"
#include "server/catalogue/child_process.hpp"
#include "server/catalogue/import_process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vti_text.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>

#include <cmath>
#include <random>

namespace wakesurf::server {
namespace {

using namespace tests;
namespace fs = std::filesystem;

struct Outcome {
    int status = 0;
    std::string errors;
    std::vector<std::string> lines;
};

Outcome import(const std::vector<std::string>& arguments) {
    Outcome out;
    const auto run = run_child(WAKESURF_IMPORT_BINARY, arguments, 0,
                               [&](std::string_view line) { out.lines.emplace_back(line); }, {});
    out.status = run->signal != 0 ? -run->signal : run->exit_status;
    out.errors = run->errors;
    return out;
}

class Import : public testing::Test {
  protected:
    fs::path store() const { return folder_ / "store"; }

    fs::path put(const std::string& name, const std::string& text) const {
        write_file(folder_ / name, text);
        return folder_ / name;
    }

    Outcome run(const std::string& name, std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {folder_ / name, store()});
        return import(options);
    }

    // Fails with status 1 and one line on standard error that holds `words`; no store is left complete.
    void expect_refusal(const std::string& name,
                        const std::string& words,
                        std::vector<std::string> options = {}) {
        const auto outcome = run(name, std::move(options));
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_NE(outcome.errors.find(words), std::string::npos) << name << ": " << outcome.errors;
        EXPECT_TRUE(outcome.errors.starts_with("wakesurf-import: ")) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
            << outcome.errors;
        EXPECT_EQ(outcome.errors.find(folder_.path().string()), std::string::npos)
            << outcome.errors;
        const auto manifest = protocol::read_store_manifest(store(), core::PosixDisk());
        EXPECT_FALSE(manifest && manifest->complete) << name;
        fs::remove_all(store());
    }

    protocol::StoreManifest manifest() const {
        return protocol::read_store_manifest(store(), core::PosixDisk()).value();
    }

    std::shared_ptr<const core::StoreReader> reader() const {
        return core::StoreReader::open(protocol::store_layout(manifest(), store()),
                                       std::make_shared<core::PosixDisk>())
            .value();
    }

    std::vector<float> velocity(std::size_t index) const {
        const auto step = reader()->load(index, {}).value();
        return {step->velocity().begin(), step->velocity().end()};
    }

    TemporaryFolder folder_;
};

const fs::path bundled = fs::path(WAKESURF_SOURCE_DIR) / "data" / "sqcyl" / "sqcyl.pvd";

TEST_F(Import, GivesTheValuesVtkReads) {
    ASSERT_EQ(import({bundled, store()}).status, 0);
    EXPECT_TRUE(manifest().complete);
    const auto store_reader = reader();
    const auto& grid = std::get<core::UniformGrid>(store_reader->grid());
    ASSERT_EQ(store_reader->times().size(), 16u);
    EXPECT_EQ(store_reader->times().front(), 8.5);
    std::mt19937 random(7);
    for (const std::size_t index : {0u, 9u, 15u}) {
        auto vtk = vtkSmartPointer<vtkXMLImageDataReader>::New();
        const std::string number = std::string(index < 10 ? "00" : "0") + std::to_string(index);
        vtk->SetFileName((bundled.parent_path() / ("sqcyl_" + number + ".vti")).c_str());
        vtk->Update();
        vtkDataArray* wanted = vtk->GetOutput()->GetPointData()->GetArray("U");
        vtkDataArray* mask = vtk->GetOutput()->GetPointData()->GetArray("mask");
        const auto step = store_reader->load(index, {}).value();
        for (int i = 0; i < 1000; ++i) {
            const auto node = random() % grid.nodes();
            const auto id = static_cast<vtkIdType>(node);
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(step->velocity()[3 * node + static_cast<std::size_t>(c)],
                          static_cast<float>(wanted->GetComponent(id, c)))
                    << "step " << index << " node " << node;
            ASSERT_EQ(store_reader->mask().fluid[node], mask->GetTuple1(id));
            const auto dimensions = grid.dimensions;
            const core::Vec3 ijk(node % dimensions[0], node / dimensions[0] % dimensions[1],
                                 node / dimensions[0] / dimensions[1]);
            const auto here = grid.origin + ijk * grid.spacing;
            ASSERT_NEAR(glm::distance(here,
                                      [&] {
                                          const double* p = vtk->GetOutput()->GetPoint(id);
                                          return core::Vec3(p[0], p[1], p[2]);
                                      }()),
                        0.0, 1e-12);
        }
    }
}

TEST_F(Import, DescribesASourceWithoutWritingAnything) {
    const auto info = describe_with_import_process({bundled, {}, {}, {}, WAKESURF_IMPORT_BINARY});
    ASSERT_TRUE(info.has_value()) << info.error().message;
    EXPECT_EQ(info->velocity, "U");
    EXPECT_EQ(info->points, 96u * 48u * 24u);
    EXPECT_EQ(info->times.size(), 16u);
    EXPECT_TRUE(info->obstacle);
    EXPECT_FALSE(info->steady);
    EXPECT_FALSE(fs::exists(store()));
}

TEST_F(Import, TellsItsProgressInJsonLines) {
    const auto outcome = import({bundled, store()});
    ASSERT_EQ(outcome.lines.size(), 17u);
    for (std::size_t i = 0; i < 16; ++i) {
        const auto progress = parse_progress_line(outcome.lines[i]);
        ASSERT_TRUE(progress.has_value()) << outcome.lines[i];
        EXPECT_EQ(progress->phase, "import");
        EXPECT_EQ(progress->done, i + 1);
        EXPECT_EQ(progress->total, 16u);
    }
    EXPECT_EQ(parse_progress_line(outcome.lines[16])->phase, "done");
}

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
        ::execl(WAKESURF_IMPORT_BINARY, "wakesurf-import", source.c_str(), target.c_str(), nullptr);
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
        {bundled, store(), {}, {}, WAKESURF_IMPORT_BINARY},
        [&](const ImportProgress& progress) {
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
        run_import_process({folder_ / "a.vti", store(), {}, {}, WAKESURF_IMPORT_BINARY},
                           [&](const ImportProgress& progress) {
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

TEST_F(Import, ReadsANumberedSeriesFromItsFirstFile) {
    for (const int i : {8, 9, 10})
        put("flow_" + std::to_string(i) + ".vti", sample_vti(i).text());
    const auto outcome = run("flow_8.vti");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(manifest().info.name, "flow");
    EXPECT_EQ(velocity(2)[0], 10.0f); // in order of number, not of name
    EXPECT_NE(outcome.lines.front().find("carry no times"), std::string::npos)
        << outcome.lines.front();
    fs::remove_all(store());
    ASSERT_EQ(run("flow_9.vti").status, 0); // not the first: alone
    EXPECT_TRUE(manifest().info.steady);
}

TEST_F(Import, TakesTheTimesTheFilesCarry) {
    for (const int i : {0, 1}) {
        auto file = sample_vti(i);
        file.field = "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                     "format=\"ascii\">" +
                     std::to_string(0.25 + i) + "</DataArray>";
        put("t" + std::to_string(i) + ".vti", file.text());
    }
    ASSERT_EQ(run("t0.vti").status, 0);
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{0.25, 1.25}));
}

TEST_F(Import, SortsACollectionByTime) {
    put("s.pvd", pvd_text({{"2", "b.vti"}, {"-1.5", "a.vti"}}));
    put("a.vti", sample_vti(1).text());
    put("b.vti", sample_vti(2).text());
    ASSERT_EQ(run("s.pvd").status, 0);
    EXPECT_EQ(manifest().layout.times, (std::vector<double>{-1.5, 2}));
    EXPECT_EQ(velocity(0)[0], 1.0f);
}

TEST_F(Import, AveragesCellDataToThePoints) {
    VtiText file;
    file.cells =
        vti_array("U", 3, file.cell_count(), [](std::size_t i) { return i % 3 == 0 ? 2.0 : 0.0; });
    put("c.vti", file.text());
    ASSERT_EQ(run("c.vti").status, 0);
    for (std::size_t i = 0; i < file.point_count(); ++i)
        EXPECT_FLOAT_EQ(velocity(0)[3 * i], 2.0f);
    EXPECT_EQ(manifest().info.fields.at(0).source, core::FieldInfo::Source::Cell);
    EXPECT_NE(manifest().info.why.find("averaged"), std::string::npos) << manifest().info.why;
}

TEST_F(Import, ZeroesTheSolidAndInvertsAMaskThatMarksIt) {
    auto file = sample_vti(5);
    file.points =
        vti_array("U", 3, file.point_count(),
                  [](std::size_t i) { return i < 3 ? std::nan("") : 1.0; }) +
        vti_array(
            "solid", 1, file.point_count(), [](std::size_t i) { return i == 0 ? 1 : 0; }, "UInt8");
    put("m.vti", file.text());
    const auto outcome = run("m.vti");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(reader()->mask().fluid[0], 0);
    EXPECT_EQ(reader()->mask().fluid[1], 1);
    EXPECT_EQ(velocity(0)[0], 0.0f);
    EXPECT_TRUE(manifest().info.obstacle);
    EXPECT_EQ(manifest().velocity_range[0],
              manifest().velocity_range[1]); // the solid does not count
}

TEST_F(Import, RefusesFilesThatAreNotWhatTheySay) {
    expect_refusal("missing.vti", "missing.vti");
    put("empty.vti", "");
    expect_refusal("empty.vti", "empty");
    put("empty.pvd", "");
    expect_refusal("empty.pvd", "empty");
    put("text.vti", "this is not XML, whatever ends it: </VTKFile>");
    expect_refusal("text.vti", "text.vti");
    put("text.pvd", "neither is this");
    expect_refusal("text.pvd", "text.pvd");
    put("wrong.pvd", sample_vti().text());
    expect_refusal("wrong.pvd", "Collection");
    put("wrong.vti", pvd_text({{"0", "a.vti"}}));
    expect_refusal("wrong.vti", "wrong.vti");
    put("mesh.xyz", "1 2 3");
    expect_refusal("mesh.xyz", "format");
    put("none.pvd", pvd_text({}));
    expect_refusal("none.pvd", "names no files");
}

TEST_F(Import, RefusesATruncatedFileWhereverItIsCut) {
    const std::string whole = read_file(bundled.parent_path() / "sqcyl_000.vti");
    for (std::size_t size = 1; size < whole.size(); size += whole.size() / 12) {
        put("cut.vti", whole.substr(0, size));
        expect_refusal("cut.vti", "cut.vti");
    }
    // Cut in the middle, with an end that looks whole.
    put("cut.vti", whole.substr(0, whole.size() / 2) + "\n</AppendedData>\n</VTKFile>\n");
    expect_refusal("cut.vti", "cut.vti");
    const std::string text = sample_vti().text();
    put("cut.vti", text.substr(0, text.size() / 2) + "</VTKFile>");
    expect_refusal("cut.vti", "cut.vti");
}

TEST_F(Import, RefusesAFileWithTooFewValues) {
    auto file = sample_vti();
    file.points = vti_array("U", 3, file.point_count() - 1, [](std::size_t) { return 1.0; });
    put("few.vti", file.text());
    expect_refusal("few.vti", "few.vti");
}

TEST_F(Import, RefusesAFileWhosePiecesLeaveAHole) {
    auto text = sample_vti().text();
    const std::string piece = "<Piece Extent=\"0 2";
    text.replace(text.find(piece), piece.size(), "<Piece Extent=\"0 1");
    put("hole.vti", text);
    expect_refusal("hole.vti", "hole.vti");
}

TEST_F(Import, RefusesAClaimOfEnormousSize) {
    auto text = sample_vti().text();
    for (auto at = text.find("0 2 0 3 0 4"); at != std::string::npos; at = text.find("0 2 0 3 0 4"))
        text.replace(at, 11, "0 2000000 0 2000000 0 2000000");
    put("huge.vti", text);
    expect_refusal("huge.vti", "huge.vti");
}

TEST_F(Import, ListsWhatThereIsWhenTheVelocityIsNotClear) {
    VtiText file;
    const auto one = [](std::size_t) { return 1.0; };
    file.points = vti_array("p", 1, file.point_count(), one);
    put("none.vti", file.text());
    expect_refusal("none.vti", "no vector field; there is p (1 component, point)");
    file.points = "";
    put("nothing.vti", file.text());
    expect_refusal("nothing.vti", "no arrays at all");
    file.points =
        vti_array("wind", 3, file.point_count(), one) + vti_array("B", 3, file.point_count(), one);
    put("two.vti", file.text());
    expect_refusal("two.vti", "wind (3 components, point), B (3 components, point)");
    expect_refusal("two.vti", "there is no field V", {"--fields", "V"});
    ASSERT_EQ(run("two.vti", {"--fields", "B"}).status, 0);
    EXPECT_EQ(manifest().info.velocity, "B");
    fs::remove_all(store());
    file.points += vti_array("Velocity", 3, file.point_count(), one);
    put("three.vti", file.text());
    ASSERT_EQ(run("three.vti").status, 0);
    EXPECT_EQ(manifest().info.velocity, "Velocity");
}

TEST_F(Import, RefusesVelocitiesThatAreNotFinite) {
    auto file = sample_vti();
    file.points = vti_array("U", 3, file.point_count(),
                            [](std::size_t i) { return i == 10 ? std::nan("") : 1.0; });
    put("nan.vti", file.text());
    expect_refusal("nan.vti", "nan.vti is not a finite number at node 3");
    file.points = vti_array(
        "U", 3, file.point_count(), [](std::size_t i) { return i == 10 ? 1e300 : 1.0; }, "Float64");
    put("big.vti", file.text());
    expect_refusal("big.vti", "big.vti is not a finite number at node 3");
}

TEST_F(Import, RefusesMasksThatAreNoMasksOrMove) {
    const auto with_mask = [](const std::function<double(std::size_t)>& value) {
        auto file = sample_vti();
        file.points += vti_array("mask", 1, file.point_count(), value);
        return file.text();
    };
    put("half.vti", with_mask([](std::size_t i) { return i == 7 ? 0.5 : 1.0; }));
    expect_refusal("half.vti", "at node 7");
    put("m0.vti", with_mask([](std::size_t i) { return i == 7 ? 0 : 1; }));
    put("m1.vti", with_mask([](std::size_t i) { return i == 8 ? 0 : 1; }));
    expect_refusal("m0.vti", "m1.vti has another mask than m0.vti");
}

TEST_F(Import, RefusesGridsItCannotHold) {
    auto file = sample_vti();
    file.direction = "0 1 0 1 0 0 0 0 1";
    put("rotated.vti", file.text());
    expect_refusal("rotated.vti", "rotated");
    file = VtiText();
    file.nodes[2] = 1;
    file.points = vti_array("U", 3, file.point_count(), [](std::size_t) { return 1.0; });
    put("flat.vti", file.text());
    expect_refusal("flat.vti", "not three-dimensional: it has 1 nodes along z");
    for (const char* spacing : {"0 1 1", "-1 1 1", "nan 1 1", "1e200 1 1"}) {
        file = sample_vti();
        file.spacing = spacing;
        put("spacing.vti", file.text());
        expect_refusal("spacing.vti", "spacing.vti");
    }
}

TEST_F(Import, RefusesASeriesWhosePartsDisagree) {
    put("a.vti", sample_vti().text());
    auto other = sample_vti();
    other.spacing = "1 1 2";
    put("b.vti", other.text());
    put("grid.pvd", pvd_text({{"0", "a.vti"}, {"1", "b.vti"}}));
    expect_refusal("grid.pvd", "b.vti has another grid than a.vti");
    put("gone.pvd", pvd_text({{"0", "a.vti"}, {"1", "gone.vti"}}));
    expect_refusal("gone.pvd", "gone.pvd names gone.vti, which is not there");
    put("twice.pvd", pvd_text({{"1", "a.vti"}, {"1", "b.vti"}}));
    expect_refusal("twice.pvd", "the same time");
    for (const char* time : {"soon", "nan", "1e999"}) {
        put("time.pvd", pvd_text({{time, "a.vti"}}));
        expect_refusal("time.pvd", "no finite number");
    }
    VtiText renamed;
    renamed.points = vti_array("V", 3, renamed.point_count(), [](std::size_t) { return 1.0; });
    put("v.vti", renamed.text());
    put("field.pvd", pvd_text({{"0", "a.vti"}, {"1", "v.vti"}}));
    expect_refusal("field.pvd", "v.vti has no field U");
}

TEST_F(Import, TellsWrongUsageFromFailure) {
    EXPECT_EQ(import({}).status, 2);
    EXPECT_EQ(import({bundled}).status, 2);
    EXPECT_EQ(import({bundled, store(), "--describe"}).status, 2);
    EXPECT_EQ(import({bundled, store(), "--frobnicate"}).status, 2);
    for (const char* times : {"1", "2:1", "a:b", "1:2:0", "1:2:1.5", "1:2:3:4", "1:", "nan:nan"})
        EXPECT_EQ(import({bundled, store(), "--times", times}).status, 2) << times;
    EXPECT_EQ(import({"--help"}).status, 0);
    EXPECT_EQ(import({bundled, store(), "--times", "100:200"}).status, 1);
    EXPECT_EQ(import({bundled, "/proc/nowhere/store"}).status, 1);
}

} // namespace
} // namespace wakesurf::server
