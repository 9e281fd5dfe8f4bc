// Series of time-steps: several processes, sources that grow, and what happens where one cannot be converted.
#include "core/base/half.hpp"
#include "tests/importer/import_fixture.hpp"

#include <cmath>
#include <fstream>

namespace wakesurf::importer::import_steps_test {
namespace {

class ImportSteps : public Import {
  protected:
    // s.pvd of n files, each with U and p.
    void put_series(std::size_t n) const {
        std::vector<std::pair<std::string, std::string>> entries;
        for (std::size_t i = 0; i < n; ++i) {
            const std::string name = "step" + std::to_string(i) + ".vti";
            entries.emplace_back(std::to_string(i), name);
            if (fs::exists(folder_ / name))
                continue;
            auto file = sample_vti(static_cast<double>(i));
            file.points += vti_array("p", 1, file.point_count(), [&](std::size_t k) {
                return 100.0 * static_cast<double>(i) + static_cast<double>(k);
            });
            put(name, file.text());
        }
        put("s.pvd", pvd_text(entries));
    }

    void expect_same_stores(const fs::path& a, const fs::path& b) const {
        std::size_t files = 0;
        for (const auto& entry : fs::directory_iterator(a)) {
            const auto other = b / entry.path().filename();
            ASSERT_TRUE(fs::exists(other)) << other;
            EXPECT_TRUE(read_file(entry.path()) == read_file(other)) << other;
            ++files;
        }
        EXPECT_EQ(files, static_cast<std::size_t>(std::distance(fs::directory_iterator(b), {})));
    }

    core::FileIdentity identity(const char* name) const {
        return core::PosixDisk().identity(store() / name).value();
    }
};

TEST_F(ImportSteps, AreTheSameBytesHoweverManyProcessesConvertThem) {
    put_series(9);
    ASSERT_EQ(run("s.pvd", {"--jobs", "1"}).status, 0);
    for (const char* jobs : {"2", "5"}) {
        const fs::path other = folder_ / "other";
        fs::remove_all(other);
        ASSERT_EQ(import({folder_ / "s.pvd", other, "--jobs", jobs}).status, 0);
        expect_same_stores(store(), other);
    }
}

TEST_F(ImportSteps, CarryScalarsAlong) {
    put_series(3);
    ASSERT_EQ(run("s.pvd").status, 0);
    ASSERT_EQ(manifest().layout.scalars, (std::vector<store::StoredScalar>{{"p", "p"}}));
    const auto slab = reader()->load_scalar(0, 2, {}).value();
    EXPECT_EQ(reinterpret_cast<const float*>(slab.bytes().data())[5], 205.0f);
    for (const auto& field : manifest().info.fields)
        if (field.name == "p") {
            EXPECT_EQ(field.range, (std::array<double, 2>{0.0, 259.0})); // over all time-steps
        }
}

TEST_F(ImportSteps, OfASourceThatHasGrownAreAddedToTheOldOnes) {
    put_series(3);
    ASSERT_EQ(run("s.pvd").status, 0);
    const auto kept = identity("velocity_000001.f32");
    put_series(5);
    const auto outcome = run("s.pvd");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(identity("velocity_000001.f32"), kept);
    ASSERT_EQ(outcome.lines.size(), 3u); // two time-steps and the end
    EXPECT_EQ(store::parse_progress_line(outcome.lines[0])->done, 4u);
    EXPECT_EQ(store::parse_progress_line(outcome.lines[1])->remaining, 0.0);
    const fs::path fresh = folder_ / "fresh";
    ASSERT_EQ(import({folder_ / "s.pvd", fresh}).status, 0);
    expect_same_stores(fresh, store());
}

TEST_F(ImportSteps, AreAllConvertedAgainWhenAnOldOneHasChanged) {
    put_series(3);
    ASSERT_EQ(run("s.pvd").status, 0);
    const auto old = identity("velocity_000000.f32");
    put("step1.vti", sample_vti(50).text() + "\n");
    put("step1.vti", read_file(folder_ / "step2.vti"));
    ASSERT_EQ(run("s.pvd").status, 0);
    EXPECT_NE(identity("velocity_000000.f32"), old);
    EXPECT_EQ(velocity(1)[0], 2.0f);
}

TEST_F(ImportSteps, EndBeforeOneThatIsCutOffAndGoOnOnceItIsWhole) {
    put_series(6);
    const std::string whole = read_file(folder_ / "step3.vti");
    // With its end missing it is found when the source is opened, with numbers missing when it is converted.
    const std::string torn = whole.substr(0, whole.size() / 2);
    std::string short_of_numbers = whole;
    short_of_numbers.erase(whole.find("</DataArray>") - 50, 40);
    for (const std::string& cut : {torn, short_of_numbers}) {
        put("step3.vti", cut);
        for (int time = 0; time < 2; ++time) {
            const auto outcome = run("s.pvd");
            EXPECT_EQ(outcome.status, 0) << outcome.errors;
            const auto note = manifest().info.note;
            EXPECT_NE(note.find("the data end before time 3: step3.vti"), std::string::npos)
                << note;
            EXPECT_NE(outcome.lines.back().find("done"), std::string::npos);
        }
        EXPECT_TRUE(manifest().complete);
        EXPECT_EQ(manifest().layout.times, (std::vector<double>{0, 1, 2}));
        EXPECT_EQ(manifest().source.steps.size(), 4u) << "its files are watched";
        EXPECT_EQ(velocity(2)[0], 2.0f);
        EXPECT_FALSE(fs::exists(store() / "velocity_000003.f32"));
        const auto info =
            describe_with_import_process({folder_ / "s.pvd", {}, {}, {}, importer_program()})
                .value();
        EXPECT_EQ(info.times.size(), cut == torn ? 3u : 6u) << "only some are read beforehand";
    }
    put("step3.vti", whole);
    const auto kept = identity("velocity_000002.f32");
    ASSERT_EQ(run("s.pvd").status, 0);
    EXPECT_TRUE(reader()->ready(5));
    EXPECT_EQ(identity("velocity_000002.f32"), kept);
    EXPECT_EQ(manifest().info.note.find("the data end"), std::string::npos) << manifest().info.note;
    put("step0.vti", torn);
    EXPECT_EQ(run("s.pvd").status, 1);
}

// Two blocks that share a face; their velocities jump there at the third of five time-steps alone.
TEST_F(ImportSteps, WithAJumpBetweenPiecesAtOneOfThemKeepThePiecesApartAtAll) {
    std::vector<std::pair<std::string, std::string>> entries;
    for (int step = 0; step < 5; ++step) {
        const std::string number = std::to_string(step);
        std::string blocks = "<VTKFile type=\"vtkMultiBlockDataSet\"><vtkMultiBlockDataSet>";
        for (int side = 0; side < 2; ++side) {
            const std::string name = "b" + number + std::to_string(side) + ".vti";
            VtiText block;
            const double along = step == 2 && side == 1 ? -1.0 : 1.0;
            block.points = vti_array("U", 3, block.point_count(),
                                     [&](std::size_t i) { return i % 3 == 0 ? along : 0.0; });
            block.origin = side == 0 ? "0 0 0" : std::to_string(2 * side) + " 0 0";
            put(name, block.text());
            blocks += "<DataSet index=\"" + std::to_string(side) + "\" file=\"" + name + "\"/>";
        }
        put("b" + number + ".vtm", blocks + "</vtkMultiBlockDataSet></VTKFile>");
        entries.emplace_back(number, "b" + number + ".vtm");
    }
    put("s.pvd", pvd_text(entries));
    const auto outcome = run("s.pvd");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_NE(manifest().info.note.find("apart from others at the same place"), std::string::npos)
        << manifest().info.note;
    EXPECT_EQ(manifest().info.points, 2 * sample_vti().point_count());
}

TEST_F(ImportSteps, OfAnotherMeshAreRefusedByName) {
    put_series(3);
    auto other = sample_vti();
    other.spacing = "1 1 2";
    put("step2.vti", other.text());
    const auto outcome = run("s.pvd", {"--fields", "U"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.errors.find("step2.vti"), std::string::npos) << outcome.errors;
}

TEST_F(ImportSteps, InHalfPrecisionTakeHalfTheSizeAndSayWhatThatCosts) {
    put_series(2);
    ASSERT_EQ(run("s.pvd", {"--precision", "half"}).status, 0);
    const auto info = manifest().info;
    EXPECT_EQ(info.precision, core::Precision::Half);
    EXPECT_NE(info.note.find("2^-11"), std::string::npos) << info.note;
    EXPECT_EQ(fs::file_size(store() / "velocity_000001.f16"), 60u * 3 * 2);
    const auto stored = velocity(1);
    for (std::size_t i = 0; i < stored.size(); ++i)
        EXPECT_NEAR(stored[i], static_cast<double>(i + 1), static_cast<double>(i + 1) / 2048);
    auto large = sample_vti(1e5);
    put("large.vti", large.text());
    const auto outcome = import({folder_ / "large.vti", folder_ / "large", "--precision", "half"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.errors.find("65504"), std::string::npos) << outcome.errors;
}

TEST_F(ImportSteps, AreNotReadFromOutsideOfTheCollectionsFolderWhenConfined) {
    const TemporaryFolder elsewhere;
    write_file(elsewhere / "secret.vti", sample_vti().text());
    fs::create_symlink(elsewhere / "secret.vti", folder_ / "link.vti");
    fs::create_directory(folder_ / "case");
    put("beside.vti", sample_vti().text());
    put("case/own.vti", sample_vti().text());
    for (const std::string& name :
         {std::string("../beside.vti"), (elsewhere / "secret.vti").string()}) {
        put("case/s.pvd", pvd_text({{"0", name}}));
        expect_refusal("case/s.pvd", "which lies outside of its folder", {"--confined"});
    }
    put("l.pvd", pvd_text({{"0", "link.vti"}}));
    expect_refusal("l.pvd", "l.pvd names link.vti, which lies outside of its folder",
                   {"--confined"});
    put("l.vti.series",
        R"({"file-series-version": "1.0", "files": [{"name": "link.vti", "time": 0}]})");
    expect_refusal("l.vti.series", "which lies outside of its folder", {"--confined"});
    put("n_0.vti", sample_vti().text());
    fs::create_symlink(elsewhere / "secret.vti", folder_ / "n_1.vti");
    expect_refusal("n_0.vti", "the series of n_0.vti names n_1.vti, which lies outside",
                   {"--confined"});
    EXPECT_EQ(run("link.vti", {"--confined"}).status,
              0); // someone who names a link knows where it leads
}

} // namespace
} // namespace wakesurf::importer::import_steps_test
