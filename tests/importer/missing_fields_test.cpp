// Files in which a part or a time-step lacks a field, or the velocity.
#include "importer/import_plan.hpp"
#include "importer/sources/open_source.hpp"
#include "tests/importer/cgns_files.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/importer/vtk_files.hpp"

#include <vtkDataSetWriter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkXMLMultiBlockDataWriter.h>

namespace wakesurf::importer::missing_fields_test {
namespace {

using namespace tests;

class MissingFields : public VtkFiles {};

TEST_F(MissingFields, ThatIncludeTheVelocityMakeASolidAlsoOneThatIsDisplaced) {
    auto fluid = sample_mesh();
    put_known_flow(*fluid, 0);
    auto more = sample_mesh(20);
    put_known_flow(*more, 0);
    more->GetPointData()->GetArray("p")->SetName("yplus");
    auto solid = sample_mesh(40);
    put_known_flow(*solid, 0);
    solid->GetPointData()->GetArray("U")->SetName("displacement");
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, solid);
    blocks->SetBlock(1, fluid);
    blocks->SetBlock(2, more);
    auto writer = vtkSmartPointer<vtkXMLMultiBlockDataWriter>::New();
    writer->SetFileName((folder_ / "m.vtm").c_str());
    writer->SetInputData(blocks);
    ASSERT_EQ(writer->Write(), 1);
    const auto source = open_source(folder_ / "m.vtm");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().note, "left out, as only some parts have them: p, yplus");
    const auto read = (*source)->read(0, (*source)->description().fields);
    ASSERT_TRUE(read.has_value()) << read.error().message;
    ASSERT_EQ(read->blocks.size(), 2u);
    for (const auto& block : read->blocks)
        expect_known_flow(*block, 0);
    ASSERT_EQ(read->solids.size(), 1u);
    EXPECT_EQ(read->solids[0]->GetBounds()[1], 43.0);
}

TEST_F(MissingFields, OfOneTimeStepAreLeftOut) {
    for (const int kind : {0, 1, 2}) { // of appended, text and binary data
        mode_ = kind;
        for (int step = 0; step < 4; ++step) {
            auto grid = sample_image();
            put_known_flow(*grid, step);
            if (step == 2)
                grid->GetPointData()->GetArray("p")->SetName("T");
            write("s" + std::to_string(step) + ".vti", *grid);
        }
        const auto plan = make_plan({folder_ / "s0.vti"});
        ASSERT_TRUE(plan.has_value()) << plan.error().message;
        EXPECT_TRUE(
            std::ranges::none_of(plan->fields, [](const auto& f) { return f.name == "p"; }));
        EXPECT_NE(plan->time_note.find("not at every time-step: T, p"), std::string::npos);
        EXPECT_EQ(plan->times, (std::vector<double>{0, 1, 2, 3}));
        for (int step = 0; step < 4; ++step)
            expect_known_flow(*plan->read(static_cast<std::size_t>(step))->blocks[0], step);
    }
}

TEST_F(MissingFields, OfPlanesAreToldAsThoseInSpaceWhateverTheVelocityLacks) {
    const auto array = [](const std::string& name, int components) {
        return "<DataArray type=\"Float32\" Name=\"" + name + "\" NumberOfComponents=\"" +
               std::to_string(components) + "\" format=\"ascii\">" +
               (components == 1 ? "1 2 3 4" : "1 2 3 4 5 6 7 8") + "</DataArray>";
    };
    const std::array<std::string, 2> velocities{array("u", 1) + array("v", 1), array("U", 2)};
    for (std::size_t kind = 0; kind < velocities.size(); ++kind)
        for (const int bare : {0, 1}) {
            const std::string stem = "k" + std::to_string(2 * kind + bare) + "_";
            for (int step = 0; step < 3; ++step)
                put(stem + std::to_string(step) + ".vti",
                    "<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData WholeExtent=\"0 1 0 1 "
                    "0 "
                    "0\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"0 1 0 1 0 "
                    "0\"><PointData>" +
                        (step == bare ? array("s", 1) : array("s", 1) + velocities[kind]) +
                        "</PointData></Piece></ImageData></VTKFile>");
            const auto plan = make_plan({folder_ / (stem + "0.vti")});
            ASSERT_TRUE(plan.has_value()) << plan.error().message;
            EXPECT_EQ(plan->times.size(), 2u);
            EXPECT_NE(plan->time_note.find("left out, as there is no "), std::string::npos)
                << plan->time_note;
        }
}

// Writes five time-steps of an image, of which some have no velocity, or one of another name.
class BareSteps : public MissingFields {
  protected:
    static vtkSmartPointer<vtkImageData> step(int number, const std::string& velocity) {
        auto grid = sample_image();
        put_known_flow(*grid, number);
        if (velocity.empty())
            grid->GetPointData()->RemoveArray("U");
        else
            grid->GetPointData()->GetArray("U")->SetName(velocity.c_str());
        return grid;
    }

    std::filesystem::path write_series(const std::vector<std::string>& velocities) const {
        std::string pvd = "<VTKFile type=\"Collection\"><Collection>";
        for (std::size_t i = 0; i < velocities.size(); ++i) {
            const std::string name = "r_" + std::to_string(i) + ".vti";
            write(name, *step(static_cast<int>(i), velocities[i]));
            pvd += "<DataSet timestep=\"" + std::to_string(0.5 * static_cast<double>(i)) +
                   "\" file=\"" + name + "\"/>";
        }
        return put("r.pvd", pvd + "</Collection></VTKFile>");
    }

    // Expects the steps at these times, each of which has the known flow as `velocity`.
    static void expect_plan(const std::filesystem::path& path,
                            const std::vector<double>& times,
                            const std::string& velocity,
                            const std::string& note,
                            const std::string& wish = {},
                            const std::vector<TimeSelection>& ranges = {}) {
        ImportRequest request{path, {}, ranges};
        request.taken.velocity = wish;
        const auto plan = make_plan(request);
        ASSERT_TRUE(plan.has_value()) << path << ": " << plan.error().message;
        EXPECT_EQ(plan->times, times) << path;
        EXPECT_EQ(plan->choice.velocity_name, velocity);
        EXPECT_EQ(plan->time_note, note);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const auto read = plan->read(i);
            ASSERT_TRUE(read.has_value()) << read.error().message;
            auto* u = read->blocks[0]->GetPointData()->GetArray(velocity.c_str());
            const auto exact =
                known_velocity(read->blocks[0]->GetPoint(3), static_cast<int>(plan->steps[i]));
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(u->GetComponent(3, c), exact[static_cast<std::size_t>(c)], 1e-5);
        }
    }
};

TEST_F(BareSteps, AreLeftOutWhereverTheyAre) {
    expect_plan(write_series({"", "U", "U", "U"}), {0.5, 1, 1.5}, "U",
                "left out, as there is no U: time 0");
    expect_plan(write_series({"", "", "U", "", "U"}), {1, 2}, "U",
                "left out, as there is no U: times 0, 0.5, 1.5");
    expect_plan(write_series({"", "", "U", "", "U"}), {1}, "U",
                "left out, as there is no U: time 1.5", {}, {{1, 1.5, 1}});
    write_series({"", "U", "U", "", "U"});
    expect_plan(
        folder_ / "r_0.vti", {1, 2, 4}, "U",
        "the files carry no times: 0, 1, 2, ... are used; left out, as there is no U: times 0, 3");
}

TEST_F(BareSteps, ThatHaveAnotherVelocityAreNamedWithIt) {
    const auto path = write_series({"velocity", "velocity", "U", "U"});
    expect_plan(path, {0, 0.5}, "velocity",
                "left out, as there is no velocity: times 1, 1.5 (with U: --velocity)");
    expect_plan(path, {1, 1.5}, "U",
                "left out, as there is no U: times 0, 0.5 (with velocity: --velocity)", "U");
    expect_plan(path, {1, 1.5}, "U", "", {}, {{1, 1.5, 1}});
}

TEST_F(BareSteps, AreThoseWithAVectorOfAnotherKindToo) {
    expect_plan(write_series({"heat", "U", "U"}), {0.5, 1}, "U",
                "left out, as there is no U: time 0 (with heat: --velocity)");
    expect_plan(write_series({"heat", "heat"}), {0, 0.5}, "heat", "");
}

TEST_F(BareSteps, OfFilesWithoutAHeaderAreLeftOutBeforeTheFirstVelocity) {
    for (int number = 0; number < 4; ++number) {
        auto writer = vtkSmartPointer<vtkDataSetWriter>::New();
        writer->SetFileName((folder_ / ("l_" + std::to_string(number) + ".vtk")).c_str());
        writer->SetInputData(step(number, number < 2 ? "" : "U"));
        ASSERT_EQ(writer->Write(), 1);
    }
    expect_plan(folder_ / "l_0.vtk", {2, 3}, "U",
                "the files carry no times: 0, 1, 2, ... are used; left out, as there is no U: "
                "times 0, 1");
}

TEST_F(BareSteps, OfNetcdfFilesAreLeftOutToo) {
    for (int number = 0; number < 4; ++number) {
        Flow flow;
        flow.times = {1.0 * number};
        if (number != 1 && number != 2)
            flow.velocity = {"p", "q", "r"};
        write_flow(folder_ / ("n_" + std::to_string(number) + ".nc"), flow);
    }
    const auto plan = make_plan({folder_ / "n_0.nc"});
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    EXPECT_EQ(plan->times, (std::vector<double>{1, 2}));
    EXPECT_EQ(plan->time_note, "left out, as there is no u, v, w: times 0, 3");
    { NetcdfWriter nothing(folder_ / "n_0.nc"); }
    const auto without = make_plan({folder_ / "n_1.nc"});
    ASSERT_TRUE(without.has_value()) << without.error().message;
    EXPECT_EQ(without->times, (std::vector<double>{1, 2}));
    EXPECT_NE(without->source->description().note.find(
                  "left out: n_0.nc has no variable over x, y and z"),
              std::string::npos);
}

TEST_F(BareSteps, OfCgnsFilesBeforeTheFirstVelocityAreLeftOut) {
    for (int number = 0; number < 3; ++number)
        write_cgns(folder_ / ("c_" + std::to_string(number) + ".cgns"),
                   {.times = {1.0 * number},
                    .vector = number == 0 ? "Vorticity" : "Velocity",
                    .first_step = number});
    const auto plan = make_plan({folder_ / "c_0.cgns"});
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    EXPECT_EQ(plan->times, (std::vector<double>{1, 2}));
    EXPECT_EQ(plan->time_note, "left out, as there is no Velocity: time 0");
    for (const std::size_t index : {0u, 1u}) {
        const auto read = plan->read(index);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        auto& block = *read->blocks[0];
        EXPECT_NEAR(block.GetPointData()->GetArray("Velocity")->GetComponent(5, 1),
                    known_velocity(block.GetPoint(5), static_cast<int>(index) + 1)[1], 1e-5);
    }
}

TEST_F(BareSteps, AloneAreRefusedWithWhatThereIs) {
    const auto none = make_plan({write_series({"", "", ""})});
    expect_failure(
        none, core::Error::Code::NotFound,
        "no time-step has the velocity: r_0.vti (time-step 0): there is no vector field; "
        "there is p (1 component, point)");
    write_series({"", "U"});
    ImportRequest other{folder_ / "r.pvd"};
    other.taken.velocity = "V";
    expect_failure(make_plan(other), core::Error::Code::NotFound,
                   "no time-step has the velocity: r_1.vti (time-step 1): there is no field V; "
                   "there is U (3 components, point)");
    ImportRequest alone{folder_ / "r_0.vti"};
    alone.taken.alone = true;
    expect_failure(make_plan(alone), core::Error::Code::NotFound,
                   "r_0.vti (time-step 0): there is no vector field");
}

} // namespace
} // namespace wakesurf::importer::missing_fields_test
