// wakesurf::vtk beside the command line, on the bundled simulation: the same points of all four kinds; and which time-steps it asks for.
#include "importer/filter/vtkIntegralSurface.h"
#include "tests/support/places.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace wakesurf::importer::integral_surface_filter_test {

namespace {

using Pipeline = vtkStreamingDemandDrivenPipeline;

std::filesystem::path data() {
    return tests::source_folder() / "data/sqcyl";
}

/// The bundled series as a source that knows its times, as ParaView's reader of .pvd files; it remembers what it was asked for.
class SeriesSource : public vtkImageAlgorithm {
  public:
    static SeriesSource* New();
    std::vector<double> asked;

  protected:
    SeriesSource() { SetNumberOfInputPorts(0); }

    int RequestInformation(vtkInformation*,
                           vtkInformationVector**,
                           vtkInformationVector* outputs) override {
        std::vector<double> times;
        for (int i = 0; i < 16; ++i)
            times.push_back(8.5 + 0.5 * i);
        vtkInformation* out = outputs->GetInformationObject(0);
        const double range[2] = {times.front(), times.back()};
        out->Set(Pipeline::TIME_STEPS(), times.data(), 16);
        out->Set(Pipeline::TIME_RANGE(), range, 2);
        reader_->SetFileName((data() / "sqcyl_000.vti").c_str());
        reader_->UpdateInformation();
        out->Set(Pipeline::WHOLE_EXTENT(),
                 reader_->GetOutputInformation(0)->Get(Pipeline::WHOLE_EXTENT()), 6);
        return 1;
    }

    int
    RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
        vtkInformation* out = outputs->GetInformationObject(0);
        const double time = out->Get(Pipeline::UPDATE_TIME_STEP());
        asked.push_back(time);
        const auto index = static_cast<int>(std::lround((time - 8.5) / 0.5));
        const std::string name =
            "sqcyl_0" + std::string(index < 10 ? "0" : "") + std::to_string(index) + ".vti";
        reader_->SetFileName((data() / name).c_str());
        reader_->Update();
        vtkImageData::GetData(outputs)->ShallowCopy(reader_->GetOutput());
        vtkImageData::GetData(outputs)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
                                                              time);
        return 1;
    }

  private:
    vtkNew<vtkXMLImageDataReader> reader_;
};

vtkStandardNewMacro(SeriesSource);

/// What `wakesurf surface` writes.
vtkSmartPointer<vtkPolyData> by_command(const std::string& options) {
    const tests::TemporaryFolder folder;
    const auto file = folder / "surface.vtp";
    const std::string command = tests::server_program() + " surface " + data().string() +
                                " --store " + (folder / "store").string() +
                                " --rake \"-1.5,-1.2,1 -1.5,1.2,1\" --separation 0.2 " + options +
                                " -o " + file.string() + " >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

void expect_same(vtkPolyData& ours, vtkPolyData& theirs) {
    ASSERT_GT(theirs.GetNumberOfPoints(), 100);
    ASSERT_EQ(ours.GetNumberOfPoints(), theirs.GetNumberOfPoints());
    ASSERT_EQ(ours.GetNumberOfCells(), theirs.GetNumberOfCells());
    double worst = 0.0;
    for (vtkIdType i = 0; i < ours.GetNumberOfPoints(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            worst = std::max(worst, std::abs(ours.GetPoint(i)[axis] - theirs.GetPoint(i)[axis]));
    EXPECT_LT(worst, 1e-9);
    for (const char* name : {"s", "t", "speed", "velocity", "component", "approximated", "error"}) {
        ASSERT_NE(ours.GetPointData()->GetArray(name), nullptr) << name;
        EXPECT_EQ(ours.GetPointData()->GetArray(name)->GetRange(-1)[1],
                  theirs.GetPointData()->GetArray(name)->GetRange(-1)[1])
            << name;
    }
}

struct Filtered {
    vtkNew<SeriesSource> source;
    vtkNew<vtkIntegralSurface> filter;

    explicit Filtered(int kind) {
        filter->SetInputConnection(source->GetOutputPort());
        filter->SetKind(kind);
        filter->SetPoint1(-1.5, -1.2, 1.0);
        filter->SetPoint2(-1.5, 1.2, 1.0);
        filter->SetSeparation(0.2);
    }
};

/// Counts errors, and keeps VTK from printing them.
struct Errors : vtkCommand {
    static Errors* New() { return new Errors; }

    void Execute(vtkObject*, unsigned long, void* text) override {
        said = static_cast<const char*>(text);
    }

    std::string said;
};

} // namespace

TEST(IntegralSurfaceFilter, HasThePointsOfTheCommandLineOfAllFourKinds) {
    const struct {
        int kind;
        std::string options;
    } kinds[] = {{vtkIntegralSurface::STREAM, "--kind stream --from 8.5 --to 16"},
                 {vtkIntegralSurface::PATH, "--kind path --from 8.5 --to 16"},
                 {vtkIntegralSurface::STREAK, "--kind streak --from 8.5 --to 16"},
                 {vtkIntegralSurface::TIME, "--kind time --from 8.5 --to 12 --sweep 0.5,0,0"}};

    for (const auto& [kind, options] : kinds) {
        SCOPED_TRACE(options);
        Filtered made(kind);
        if (kind == vtkIntegralSurface::TIME) {
            made.filter->SetSweep(0.5, 0.0, 0.0);
            made.filter->SetFrom(8.5);
            made.filter->SetTo(12.0);
        }
        made.filter->Update();
        expect_same(*made.filter->GetOutput(), *by_command(options));
    }
}

TEST(IntegralSurfaceFilter, AsksForTheTimeStepsItNeedsOnceWhereverTheRakeGoes) {
    Filtered made(vtkIntegralSurface::STREAK);
    made.filter->SetFrom(9.6);
    made.filter->SetTo(11.2);
    made.filter->Update();
    EXPECT_EQ(made.source->asked, (std::vector<double>{9.5, 10.0, 10.5, 11.0, 11.5}));
    const auto points = made.filter->GetOutput()->GetNumberOfPoints();
    made.filter->SetPoint2(-1.5, 0.6, 1.0);
    made.filter->Update();
    EXPECT_LT(made.filter->GetOutput()->GetNumberOfPoints(), points);
    EXPECT_EQ(made.source->asked.size(), 5u);
    made.source->Modified(); // other data, perhaps
    made.filter->Update();
    EXPECT_GE(made.source->asked.size(), 10u);
    made.filter->SetKind(vtkIntegralSurface::STREAM); // frozen at 9.6: two time-steps
    made.source->asked.clear();
    made.filter->Update();
    EXPECT_EQ(made.source->asked, (std::vector<double>{9.5, 10.0}));
}

TEST(IntegralSurfaceFilter, ShowsTheTimeThatIsAskedForDownstream) {
    Filtered made(vtkIntegralSurface::STREAK);
    made.filter->UpdateTimeStep(11.0);
    vtkPolyData& early = *made.filter->GetOutput();
    EXPECT_EQ(early.GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 11.0);
    EXPECT_EQ(early.GetPointData()->GetArray("t")->GetRange()[1], 11.0); // released last
    const auto few = early.GetNumberOfPoints();
    made.filter->UpdateTimeStep(16.0);
    EXPECT_GT(made.filter->GetOutput()->GetNumberOfPoints(), few);
    EXPECT_EQ(made.source->asked.size(), 16u);
}

TEST(IntegralSurfaceFilter, TakesItsRakeFromASecondInput) {
    Filtered given(vtkIntegralSurface::STREAM), other(vtkIntegralSurface::STREAM);
    vtkNew<vtkPoints> ends;
    ends->SetDataTypeToDouble();
    ends->InsertNextPoint(-1.5, -1.2, 1.0);
    ends->InsertNextPoint(-1.5, 1.2, 1.0);
    vtkNew<vtkPolyData> line;
    line->SetPoints(ends);
    other.filter->SetPoint1(0.0, 0.0, 0.0);
    other.filter->SetInputData(1, line);
    given.filter->Update();
    other.filter->Update();
    expect_same(*other.filter->GetOutput(), *given.filter->GetOutput());
}

TEST(IntegralSurfaceFilter, SaysWhatIsWrongInTheWordsOfTheCommandLineAndLeavesNothing) {
    Filtered made(vtkIntegralSurface::STREAM);
    vtkNew<Errors> errors;
    made.filter->AddObserver(vtkCommand::ErrorEvent, errors);
    made.filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    made.filter->SetVelocity("no such field");
    made.filter->Update();
    EXPECT_EQ(made.filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_FALSE(errors->said.empty());
    made.filter->SetVelocity("");
    made.filter->SetPoint1(100.0, 0.0, 0.0);
    made.filter->SetPoint2(101.0, 0.0, 0.0);
    made.filter->Update();
    EXPECT_EQ(made.filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace wakesurf::importer::integral_surface_filter_test
