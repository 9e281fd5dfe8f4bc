// VTKHDF files as sources, written with HDF5: images, meshes, series, and what cannot be read.
#include "importer/sources/open_source.hpp"
#include "tests/importer/hdf_files.hpp"
#include "tests/importer/known_flow.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace wakesurf::importer::hdf_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

void write_mesh(const fs::path& path, int step, vtkIdType node_at_fault = -1) {
    auto mesh = sample_mesh();
    put_known_flow(*mesh, step);
    const auto points = static_cast<hsize_t>(mesh->GetNumberOfPoints());
    const auto cells = static_cast<hsize_t>(mesh->GetNumberOfCells());
    std::vector<long long> nodes;
    std::vector<long long> offsets{0};
    std::vector<unsigned char> types;
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i) {
        for (int n = 0; n < mesh->GetCell(i)->GetNumberOfPoints(); ++n)
            nodes.push_back(mesh->GetCell(i)->GetPointId(n));
        offsets.push_back(static_cast<long long>(nodes.size()));
        types.push_back(static_cast<unsigned char>(mesh->GetCellType(i)));
    }
    if (node_at_fault >= 0)
        nodes[5] = node_at_fault;
    HdfWriter out(path, "UnstructuredGrid");
    out.data("NumberOfPoints", {1}, std::vector{static_cast<long long>(points)}, H5T_NATIVE_LLONG);
    out.data("NumberOfCells", {1}, std::vector{static_cast<long long>(cells)}, H5T_NATIVE_LLONG);
    out.data("NumberOfConnectivityIds", {1}, std::vector{static_cast<long long>(nodes.size())},
             H5T_NATIVE_LLONG);
    out.data("Points", {points, 3}, values_of(*mesh->GetPoints()->GetData()), H5T_NATIVE_DOUBLE);
    out.data("Types", {cells}, types, H5T_NATIVE_UCHAR);
    out.data("Offsets", {cells + 1}, offsets, H5T_NATIVE_LLONG);
    out.data("Connectivity", {nodes.size()}, nodes, H5T_NATIVE_LLONG);
    out.data("PointData/U", {points, 3}, values_of(*mesh->GetPointData()->GetArray("U")),
             H5T_NATIVE_DOUBLE);
    out.data("CellData/T", {cells}, values_of(*mesh->GetCellData()->GetArray("T")),
             H5T_NATIVE_DOUBLE);
}

class HdfSource : public testing::Test {
  protected:
    TemporaryFolder folder_;
};

TEST_F(HdfSource, ReadsImagesAndMeshesAsSeries) {
    for (int step = 0; step < 3; ++step) {
        write_image(folder_ / ("i_" + std::to_string(step) + ".vtkhdf"), step);
        write_mesh(folder_ / ("m_" + std::to_string(step) + ".hdf"), step);
    }
    const auto images = open_source(folder_ / "i_0.vtkhdf");
    ASSERT_TRUE(images.has_value()) << images.error().message;
    expect_known_series(**images, {0, 1, 2});
    EXPECT_EQ((*images)->description().reader, "vtkHDFReader (vtkhdf series)");
    EXPECT_NE(vtkImageData::SafeDownCast((*images)->read(0, known_fields())->blocks[0]), nullptr);
    const auto meshes = open_source(folder_ / "m_*.hdf");
    ASSERT_TRUE(meshes.has_value()) << meshes.error().message;
    expect_known_series(**meshes, {0, 1, 2});
    EXPECT_EQ(field_named(**meshes, "U")->components, 3);
    EXPECT_EQ(field_named(**meshes, "T")->source, core::FieldInfo::Source::Cell);
}

TEST_F(HdfSource, RefusesTimeStepsInsideTheFile) {
    write_image(folder_ / "t.vtkhdf", 0);
    const hid_t file = H5Fopen((folder_ / "t.vtkhdf").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Gclose(H5Gcreate2(file, "VTKHDF/Steps", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Fclose(file);
    expect_failure(open_source(folder_ / "t.vtkhdf"), Error::Code::Unsupported,
                   "t.vtkhdf holds several time-steps in one file");
}

TEST_F(HdfSource, RefusesOtherFiles) {
    write_file(folder_ / "text.hdf", "no HDF5");
    expect_failure(open_source(folder_ / "text.hdf"), Error::Code::Corrupt, "text.hdf is damaged");
    H5Fclose(H5Fcreate((folder_ / "other.hdf").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    expect_failure(open_source(folder_ / "other.hdf"), Error::Code::Unsupported,
                   "other.hdf is HDF5 without a VTKHDF group");
    write_mesh(folder_ / "node.hdf", 0, 99);
    expect_failure(open_source(folder_ / "node.hdf"), Error::Code::Corrupt,
                   "node.hdf has a damaged cell: cell 0 has a node that is not there");
}

TEST_F(HdfSource, RefusesEveryTruncation) {
    write_image(folder_ / "whole.vtkhdf", 0);
    const auto whole = read_file(folder_ / "whole.vtkhdf");
    for (std::size_t size = 1; size < whole.size(); size += 509) {
        write_file(folder_ / "cut.vtkhdf", whole.substr(0, size));
        expect_failure(open_source(folder_ / "cut.vtkhdf"), Error::Code::Corrupt, "cut.vtkhdf");
    }
}

// How a process of its own ends that reads the file: 0 for an error or the data that were written, 1 for other data,
// minus the signal that ended it.
int read_in_child(const fs::path& file) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(60);
        const auto source = open_source(file);
        const auto read = source ? (*source)->read(0, known_fields())
                                 : core::Result<SourceStep>(tl::unexpected(source.error()));
        if (read)
            expect_known_flow(*read->blocks[0], 0);
        ::_exit(testing::Test::HasFailure() ? 1 : 0);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

// HDF5 itself may end the process on a hostile file, which an importer may: a wrong value or a standstill it may not give.
TEST_F(HdfSource, DoesNotReadOtherDataFromDamagedStructures) {
    write_mesh(folder_ / "whole.hdf", 0);
    const auto whole = read_file(folder_ / "whole.hdf");
    ASSERT_EQ(read_in_child(folder_ / "whole.hdf"), 0);
    constexpr std::size_t structures =
        2048; // superblock, groups and headers come before the values
    for (std::size_t at = 0; at < structures; at += 31) {
        auto damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
        write_file(folder_ / "flip.hdf", damaged);
        const int end = read_in_child(folder_ / "flip.hdf");
        EXPECT_NE(end, 1) << at;
        EXPECT_NE(end, -SIGALRM) << at;
    }
}

} // namespace
} // namespace wakesurf::importer::hdf_source_test
