// Writes files of VTK's own formats into a folder of the test.
#pragma once

#include "tests/importer/known_flow.hpp"
#include "tests/support/temporary_folder.hpp"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkXMLDataSetWriter.h>

namespace wakesurf::tests {

class VtkFiles : public testing::Test {
  protected:
    std::filesystem::path put(const std::string& name, const std::string& text) const {
        write_file(folder_ / name, text);
        return folder_ / name;
    }

    void set_time(vtkDataObject& data, double time) const {
        auto value = vtkSmartPointer<vtkDoubleArray>::New();
        value->SetName("TimeValue");
        value->InsertNextValue(time);
        data.GetFieldData()->AddArray(value);
    }

    std::filesystem::path write(const std::string& name, vtkDataSet& data) const {
        auto writer = vtkSmartPointer<vtkXMLDataSetWriter>::New();
        writer->SetFileName((folder_ / name).c_str());
        writer->SetDataMode(mode_);
        writer->SetInputData(&data);
        EXPECT_EQ(writer->Write(), 1);
        return folder_ / name;
    }

    std::filesystem::path write_step(const std::string& name, vtkDataSet& data, int step) const {
        put_known_flow(data, step);
        return write(name, data);
    }

    TemporaryFolder folder_;
    int mode_ = vtkXMLWriter::Appended;
};

} // namespace wakesurf::tests
