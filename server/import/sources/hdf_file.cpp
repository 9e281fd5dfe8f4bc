#include "server/import/sources/hdf_file.hpp"

#include "server/import/sources/file_names.hpp"
#include "server/import/vtk_messages.hpp"

#include <vtkHDFReader.h>
#include <vtk_hdf5.h>

#include <new>

namespace wakesurf::server {

using core::Error;
using core::FieldInfo;

namespace {

// Closes what HDF5 has opened.
class Handle {
  public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}

    ~Handle() {
        if (id_ >= 0)
            close_(id_);
    }

    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    operator hid_t() const { return id_; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

core::Result<void> check_layout(const ListedFile& file) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print
    const Handle root(H5Fopen(file.path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (root < 0)
        return core::fail(Error::Code::Corrupt,
                          file.name +
                              " is damaged or not what it says it is (HDF5 cannot open it)");
    if (H5Lexists(root, "VTKHDF", H5P_DEFAULT) <= 0)
        return core::fail(Error::Code::Unsupported, file.name + " is HDF5 without a VTKHDF group",
                          "only HDF5 files with VTK's layout can be read as .hdf");
    const Handle group(H5Gopen2(root, "VTKHDF", H5P_DEFAULT), H5Gclose);
    if (group < 0)
        return core::fail(Error::Code::Corrupt, file.name + " has a damaged VTKHDF group");
    if (H5Lexists(group, "Steps", H5P_DEFAULT) > 0)
        return core::fail(
            Error::Code::Unsupported, file.name + " holds several time-steps in one file",
            "write one .vtkhdf a time-step, numbered, or a .pvd of .vtu or .vti files");
    return {};
}

} // namespace

bool is_hdf(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".vtkhdf" || extension == ".hdf";
}

core::Result<VtkFile> read_hdf_file(const ListedFile& file, const WantedArrays& wanted) {
    if (auto sound = check_layout(file); !sound)
        return tl::unexpected(sound.error());
    const VtkMessages messages;
    auto reader = vtkSmartPointer<vtkHDFReader>::New();
    reader->SetFileName(file.path.c_str());
    try {
        reader->UpdateInformation();
        if (auto clean = messages.verdict(file.name); !clean)
            return tl::unexpected(clean.error());
        select_arrays(*reader->GetPointDataArraySelection(), FieldInfo::Source::Point, wanted);
        select_arrays(*reader->GetCellDataArraySelection(), FieldInfo::Source::Cell, wanted);
        reader->Update();
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to read " + file.name);
    }
    if (auto clean = messages.verdict(file.name); !clean)
        return tl::unexpected(clean.error());
    vtkSmartPointer<vtkDataSet> data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
    if (data == nullptr)
        return core::fail(Error::Code::Corrupt, file.name + " holds no grid");
    return VtkFile{data, "vtkHDFReader"};
}

} // namespace wakesurf::server
