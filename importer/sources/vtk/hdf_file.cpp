#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/vtk/vtk_file.hpp"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkHDFReader.h>
#include <vtkImageData.h>
#include <vtk_hdf5.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

// Closes an object that HDF5 has opened.
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

/// Returns the numbers of a 1-D attribute or data set, `most` at most; empty if it is missing or has none.
template <class Read>
std::vector<long long> numbers_of(hid_t space, std::size_t most, const Read& read) {
    const auto count = H5Sget_simple_extent_npoints(space);
    if (count <= 0 || static_cast<std::size_t>(count) > most)
        return {};
    std::vector<long long> out(static_cast<std::size_t>(count));
    return read(out.data()) < 0 ? std::vector<long long>() : out;
}

std::uint64_t product_of(const std::vector<std::uint64_t>& factors) {
    std::uint64_t out = 1;
    for (const auto factor : factors)
        if (__builtin_mul_overflow(out, factor, &out))
            return std::numeric_limits<std::uint64_t>::max();
    return out;
}

// VTK takes memory for as many nodes and cells as the file states, whatever its data sets hold.
core::Result<void> check_sizes(hid_t group, const std::string& name) {
    constexpr std::size_t most_parts = 1 << 20;
    if (H5Aexists(group, "WholeExtent") > 0) {
        const Handle extent(H5Aopen(group, "WholeExtent", H5P_DEFAULT), H5Aclose);
        const Handle space(H5Aget_space(extent), H5Sclose);
        const auto ends = numbers_of(
            space, 6, [&](long long* to) { return H5Aread(extent, H5T_NATIVE_LLONG, to); });
        std::vector<std::uint64_t> nodes;
        for (std::size_t axis = 0; axis + 1 < ends.size(); axis += 2)
            nodes.push_back(
                static_cast<std::uint64_t>(std::max(ends[axis + 1] - ends[axis] + 1, 1LL)));
        if (auto fits = check_claim(name, product_of(nodes), sizeof(float)); !fits)
            return fits;
    }
    constexpr std::array<std::pair<const char*, std::uint64_t>, 3> counts{
        {{"NumberOfPoints", 3 * sizeof(float)},
         {"NumberOfCells", sizeof(std::int64_t)},
         {"NumberOfConnectivityIds", sizeof(std::int64_t)}}};
    for (const auto& [count, bytes] : counts) {
        if (H5Lexists(group, count, H5P_DEFAULT) <= 0)
            continue;
        const Handle data(H5Dopen2(group, count, H5P_DEFAULT), H5Dclose);
        const Handle space(H5Dget_space(data), H5Sclose);
        const auto parts = numbers_of(space, most_parts, [&](long long* to) {
            return H5Dread(data, H5T_NATIVE_LLONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
        });
        for (const auto part : parts)
            if (auto fits =
                    check_claim(name, static_cast<std::uint64_t>(std::max(part, 0LL)), bytes);
                !fits)
                return fits;
    }
    return {};
}

core::Result<void> check_layout(const ListedFile& file) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print
    const Handle root(H5Fopen(file.path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (root < 0)
        return core::fail(
            Error::Code::Corrupt,
            file.name +
                " is damaged, or not the kind of file that it claims to be (HDF5 cannot open it)");
    if (H5Lexists(root, "VTKHDF", H5P_DEFAULT) <= 0)
        return core::fail(Error::Code::Unsupported, file.name + " is HDF5 without a VTKHDF group",
                          "only HDF5 files with VTK's layout can be read as .hdf");
    const Handle group(H5Gopen2(root, "VTKHDF", H5P_DEFAULT), H5Gclose);
    if (group < 0)
        return core::fail(Error::Code::Corrupt, file.name + " has a damaged VTKHDF group");
    if (H5Lexists(group, "Steps", H5P_DEFAULT) > 0)
        return core::fail(
            Error::Code::Unsupported, file.name + " holds several time-steps in one file",
            "write one .vtkhdf per time-step, numbered, or a .pvd of .vtu or .vti files");
    return check_sizes(group, file.name);
}

// VTK 9.1 asks for as many cell values of an image as it has nodes, and fails.
core::Result<void>
add_cells_of_image(vtkImageData& image, const std::string& name, const ListedFile& file) {
    const auto damaged = core::fail(Error::Code::Corrupt,
                                    file.name + " has a damaged array " + name + " in its cells");
    const Handle root(H5Fopen(file.path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    const Handle data(H5Dopen2(root, ("VTKHDF/CellData/" + name).c_str(), H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(data), H5Sclose);
    std::array<hsize_t, 4> size{1, 1, 1, 1};
    const int rank = space < 0 ? 0 : H5Sget_simple_extent_ndims(space);
    if (rank < 3 || rank > 4 || H5Sget_simple_extent_dims(space, size.data(), nullptr) < 0)
        return damaged;
    for (std::size_t axis = 0; axis < 3; ++axis) // slowest first
        if (size[2 - axis] != static_cast<hsize_t>(image.GetDimensions()[axis] - 1))
            return damaged;
    if (size[3] < 1 || size[3] > 9)
        return damaged;
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(static_cast<int>(size[3]));
    array->SetNumberOfTuples(image.GetNumberOfCells());
    if (H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array->GetPointer(0)) < 0)
        return damaged;
    image.GetCellData()->AddArray(array);
    return {};
}

// Returns the cell arrays that are read here, because VTK cannot.
std::vector<std::string> take_cell_arrays(vtkHDFReader& reader) {
    std::vector<std::string> out;
    auto* selection = reader.GetCellDataArraySelection();
    for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
        if (selection->GetArraySetting(i) != 0)
            out.emplace_back(selection->GetArrayName(i));
    selection->DisableAllArrays();
    return out;
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
    std::vector<std::string> cells;
    auto reader = vtkSmartPointer<vtkHDFReader>::New();
    reader->SetFileName(file.path.c_str());
    const auto update = [&]() -> core::Result<void> {
        reader->UpdateInformation();
        if (auto clean = messages.verdict(file.name); !clean)
            return clean;
        select_arrays(*reader->GetPointDataArraySelection(), FieldInfo::Source::Point, wanted);
        select_arrays(*reader->GetCellDataArraySelection(), FieldInfo::Source::Cell, wanted);
        if (vtkImageData::SafeDownCast(reader->GetOutputDataObject(0)) != nullptr)
            cells = take_cell_arrays(*reader);
        reader->Update();
        return messages.verdict(file.name);
    };
    if (auto clean = within_memory(file.name, update); !clean)
        return tl::unexpected(clean.error());
    vtkSmartPointer<vtkDataSet> data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
    if (data == nullptr)
        return core::fail(Error::Code::Corrupt, file.name + " holds no grid");
    for (const auto& name : cells)
        if (auto added = add_cells_of_image(*vtkImageData::SafeDownCast(data), name, file); !added)
            return tl::unexpected(added.error());
    return VtkFile{data, "vtkHDFReader"};
}

} // namespace wakesurf::importer
