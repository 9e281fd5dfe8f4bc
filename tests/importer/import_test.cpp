// What wakesurf-import makes of good sources.
#include "importer/step_conversion.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/support/programs.hpp"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace wakesurf::importer::import_test {
namespace {

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
    const auto info =
        describe_with_import_process({bundled, {}, {}, {}, tests::importer_program()});
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
        const auto progress = store::parse_progress_line(outcome.lines[i]);
        ASSERT_TRUE(progress.has_value()) << outcome.lines[i];
        EXPECT_EQ(progress->phase, "import");
        EXPECT_EQ(progress->done, i + 1);
        EXPECT_EQ(progress->total, 16u);
    }
    EXPECT_EQ(store::parse_progress_line(outcome.lines[16])->phase, "done");
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
    ASSERT_EQ(run("flow_9.vti").status, 0); // any of them will do
    EXPECT_EQ(manifest().layout.times.size(), 3u);
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

TEST_F(Import, KeepsOtherVectorsAsTheirMagnitudes) {
    auto file = sample_vti(5);
    const auto i_of = [](std::size_t number) { return static_cast<double>(number / 3); };
    // (3 i, 4 i, 12 i) has the magnitude 13 i.
    file.points += vti_array("vorticity", 3, file.point_count(), [&](std::size_t number) {
        return std::array{3.0, 4.0, 12.0}[number % 3] * i_of(number);
    });
    file.cells = vti_array("force", 3, file.cell_count(),
                           [](std::size_t number) { return number % 3 == 1 ? -2.0 : 0.0; });
    put("v.vti", file.text());
    ASSERT_EQ(run("v.vti").status, 0);
    const auto stored = manifest();
    ASSERT_EQ(stored.layout.scalars.size(), 2u);
    EXPECT_EQ(stored.layout.scalars[0].name, "vorticity magnitude");
    EXPECT_EQ(stored.layout.scalars[1].name, "force magnitude");
    const auto values_of = [&](std::size_t scalar) {
        const auto values = reader()->load_scalar(scalar, 0, {}).value();
        const auto bytes = values.bytes();
        std::vector<float> out(bytes.size() / sizeof(float));
        std::memcpy(out.data(), bytes.data(), bytes.size());
        return out;
    };
    const auto vorticity = values_of(0);
    ASSERT_EQ(vorticity.size(), file.point_count());
    for (std::size_t i = 0; i < vorticity.size(); ++i)
        EXPECT_FLOAT_EQ(vorticity[i], 13.0f * static_cast<float>(i));
    for (const float force : values_of(1))
        EXPECT_FLOAT_EQ(force, 2.0f);
    const auto& fields = stored.info.fields;
    const auto listed = std::find_if(fields.begin(), fields.end(), [](const core::FieldInfo& each) {
        return each.name == "vorticity magnitude";
    });
    ASSERT_NE(listed, fields.end());
    EXPECT_EQ(listed->components, 1);
    EXPECT_DOUBLE_EQ(listed->range[1], 13.0 * static_cast<double>(file.point_count() - 1));
    EXPECT_NE(stored.info.note.find("stored as magnitudes, since a store holds one vector: "
                                    "vorticity, force"),
              std::string::npos)
        << stored.info.note;
}

TEST(Magnitudes, OfAVectorThatLacksAComponentThereIsNone) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const auto out = magnitudes({0, none, 0, 0, 0, none, none, 1, 2, 3, 4, 12});
    ASSERT_EQ(out.size(), 4u);
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(std::isnan(out[static_cast<std::size_t>(i)])) << i;
    EXPECT_EQ(out[3], 13.0f);
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

TEST_F(Import, KeepsWhatIsNoNumberAsThat) {
    auto file = sample_vti();
    file.points = vti_array(
        "U", 3, file.point_count(),
        [](std::size_t i) { return i == 10   ? std::nan("")
                                   : i == 20 ? 1e300
                                             : 1.0; }, "Float64");
    put("nan.vti", file.text());
    ASSERT_EQ(run("nan.vti").status, 0);
    EXPECT_TRUE(reader()->load(0, {}).value()->gaps);
    const auto stored = velocity(0);
    for (std::size_t i = 0; i < stored.size(); ++i)
        EXPECT_EQ(std::isnan(stored[i]), i == 10 || i == 20) << i;
    EXPECT_NEAR(manifest().velocity_range[1], std::sqrt(3.0), 1e-6);
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
} // namespace wakesurf::importer::import_test
