// Files of VTK's writers in which a part or a time-step lacks a field.
#include "importer/sources/open_source.hpp"
#include "tests/importer/vtk_files.hpp"

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
                grid->GetPointData()->RemoveArray("p");
            write("s" + std::to_string(step) + ".vti", *grid);
        }
        const auto source = open_source(folder_ / "s0.vti");
        ASSERT_TRUE(source.has_value()) << source.error().message;
        EXPECT_EQ(field_named(**source, "p"), nullptr);
        EXPECT_NE((*source)->description().note.find("not at every time-step: p"),
                  std::string::npos)
            << (*source)->description().note;
        expect_known_series(**source, {0, 1, 2, 3});
    }
}

} // namespace
} // namespace wakesurf::importer::missing_fields_test
