// VTKHDF files for tests, written with HDF5.
#pragma once

#include "tests/importer/known_flow.hpp"

#include <gtest/gtest.h>
#include <vtk_hdf5.h>

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

// VTKHDF 1.0, as docs.vtk.org has it.
class HdfWriter {
  public:
    HdfWriter(const std::filesystem::path& path, const std::string& type) {
        file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
        root_ = H5Gcreate2(file_, "VTKHDF", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        attribute("Version", std::vector<int>{1, 0}, H5T_NATIVE_INT);
        const hid_t text = H5Tcopy(H5T_C_S1);
        H5Tset_size(text, type.size());
        H5Tset_strpad(text, H5T_STR_NULLPAD);
        const hid_t space = H5Screate(H5S_SCALAR);
        const hid_t name = H5Acreate2(root_, "Type", text, space, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(name, text, type.data());
        H5Aclose(name);
        H5Sclose(space);
        H5Tclose(text);
        group("PointData");
        group("CellData");
    }

    ~HdfWriter() {
        H5Gclose(root_);
        H5Fclose(file_);
    }

    HdfWriter(const HdfWriter&) = delete;
    HdfWriter& operator=(const HdfWriter&) = delete;

    void group(const std::string& name) {
        H5Gclose(H5Gcreate2(root_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    }

    template <class Value>
    void attribute(const std::string& name, const std::vector<Value>& values, hid_t type) {
        const hsize_t size = values.size();
        const hid_t space = H5Screate_simple(1, &size, nullptr);
        const hid_t id = H5Acreate2(root_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
        EXPECT_GE(H5Awrite(id, type, values.data()), 0);
        H5Aclose(id);
        H5Sclose(space);
    }

    template <class Value>
    void data(const std::string& name,
              const std::vector<hsize_t>& size,
              const std::vector<Value>& values,
              hid_t type) {
        const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
        const hid_t id =
            H5Dcreate2(root_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        EXPECT_GE(H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
        H5Dclose(id);
        H5Sclose(space);
    }

  private:
    hid_t file_ = -1;
    hid_t root_ = -1;
};

inline std::vector<double> values_of(vtkDataArray& array) {
    std::vector<double> out;
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
        for (int c = 0; c < array.GetNumberOfComponents(); ++c)
            out.push_back(array.GetComponent(i, c));
    return out;
}

inline void write_image(const std::filesystem::path& path, int step) {
    auto image = tests::sample_image();
    tests::put_known_flow(*image, step);
    HdfWriter out(path, "ImageData");
    out.attribute("WholeExtent", std::vector<int>{0, 3, 0, 4, 0, 5}, H5T_NATIVE_INT);
    out.attribute("Origin", std::vector<double>{-1.0, 0.5, 2.0}, H5T_NATIVE_DOUBLE);
    out.attribute("Spacing", std::vector<double>{0.5, 0.25, 1.0}, H5T_NATIVE_DOUBLE);
    out.attribute("Direction", std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}, H5T_NATIVE_DOUBLE);
    out.data("PointData/U", {6, 5, 4, 3}, values_of(*image->GetPointData()->GetArray("U")),
             H5T_NATIVE_DOUBLE);
    out.data("CellData/T", {5, 4, 3}, values_of(*image->GetCellData()->GetArray("T")),
             H5T_NATIVE_DOUBLE);
}

} // namespace wakesurf::importer
