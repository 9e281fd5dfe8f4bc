// An OpenFOAM case made cell by cell, whole or in the folders of processors, whose every value is known.
#pragma once

#include "importer/sources/files/formats.hpp"
#include "tests/support/foam_files.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>

#include <set>
#include <stdexcept>

namespace wakesurf::tests::cavity {

// Numbers that are exact as 32-bit floats and as short text; different in every cell, component and
// time-step.
inline double value_at(int cell, int component, int step) {
    return 0.125 * cell + 32.0 * component - 4.0 * step + 0.5;
}

inline FoamField velocity(const FoamMesh& mesh, int step) {
    FoamField field;
    for (const int cell : mesh.cells)
        field.values.push_back(
            {value_at(cell, 0, step), value_at(cell, 1, step), value_at(cell, 2, step)});
    field.patches["floor"] = "type noSlip;";
    field.patches["lid"] = "type fixedValue; value uniform (1 0 0);";
    return field;
}

inline FoamField pressure(const FoamMesh& mesh, int step) {
    FoamField field{"p", "[0 2 -2 0 0 0 0]", {}, {}};
    for (const int cell : mesh.cells)
        field.values.push_back({value_at(cell, 7, step)});
    return field;
}

inline const std::vector<std::string> time_names{"0", "0.5", "1e1"};

class CavityCase : public testing::Test {
  protected:
    std::filesystem::path
    put(const FoamMesh& mesh, bool binary = false, const std::string& inside = "") const {
        const std::filesystem::path place = folder_ / "cavity" / inside;
        write_foam_mesh(place / "constant", mesh, binary);
        for (int step = 0; step < 3; ++step)
            for (auto field : {velocity(mesh, step), pressure(mesh, step)}) {
                if (units_named_)
                    field.dimensions = field.name == "U" ? "[m s^-1]" : "[m^2 s^-2]";
                write_foam_field(place / time_names[static_cast<std::size_t>(step)], mesh, field,
                                 binary);
            }
        write_file(folder_ / "cavity" / "cavity.foam", "");
        return folder_ / "cavity" / "cavity.foam";
    }

    std::unique_ptr<importer::Source> open() const {
        auto source = importer::open_openfoam(folder_ / "cavity" / "cavity.foam");
        if (!source)
            throw std::runtime_error(source.error().message);
        return std::move(*source);
    }

    std::filesystem::path at(const std::string& name) const { return folder_ / "cavity" / name; }

    TemporaryFolder folder_;
    bool units_named_ = false; ///< put writes dimensions as OpenFOAM does since version 10
};

// Every cell's number follows from its first component; all others must fit it.
inline void expect_values(const importer::SourceStep& step, int index, std::size_t cells) {
    std::set<int> seen;
    for (const auto& block : step.blocks) {
        vtkDataArray* u = block->GetCellData()->GetArray("U");
        vtkDataArray* p = block->GetCellData()->GetArray("p");
        ASSERT_NE(u, nullptr);
        ASSERT_NE(p, nullptr);
        ASSERT_EQ(u->GetNumberOfTuples(), block->GetNumberOfCells());
        for (vtkIdType i = 0; i < u->GetNumberOfTuples(); ++i) {
            const int cell =
                static_cast<int>((u->GetComponent(i, 0) - value_at(0, 0, index)) / 0.125);
            seen.insert(cell);
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(u->GetComponent(i, c), value_at(cell, c, index)) << "cell " << i;
            ASSERT_EQ(p->GetTuple1(i), value_at(cell, 7, index));
        }
    }
    EXPECT_EQ(seen.size(), cells);
    EXPECT_EQ(*seen.begin(), 0);
    EXPECT_EQ(*seen.rbegin() + 1, static_cast<int>(cells));
}

} // namespace wakesurf::tests::cavity
