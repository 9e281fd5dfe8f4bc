// Files of HDF5 that lead to other files: its library follows such links and asks nobody, so that the rights of the process decide.
#include "importer/base/limited_rights.hpp"
#include "tests/importer/hdf_files.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/netcdf_files.hpp"

namespace wakesurf::importer::hdf_links_test {
namespace {

constexpr const char* word = "Zx9365tokenOfTheServer";

class HdfLinks : public Import {
  protected:
    void SetUp() override {
        fs::create_directories(folder_ / "case");
        fs::create_directories(folder_ / "other");
        write_file(folder_ / "other/token", std::string(8192, '\x3f') + word);
    }

    /// Puts a link to the same object of the other file in the place of an object.
    void link_out(const std::string& name, const std::string& object) const {
        fs::copy(folder_ / "case" / name, folder_ / "other" / name,
                 fs::copy_options::overwrite_existing);
        const hid_t file = H5Fopen((folder_ / "case" / name).c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        EXPECT_GE(H5Ldelete(file, object.c_str(), H5P_DEFAULT), 0);
        EXPECT_GE(H5Lcreate_external((folder_ / "other" / name).c_str(), object.c_str(), file,
                                     object.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                  0);
        H5Fclose(file);
    }

    /// Puts data whose bytes are those of the other file, of any format, in the place of a dataset.
    void take_bytes_of(const std::string& other,
                       const std::string& name,
                       const std::string& dataset,
                       const std::vector<hsize_t>& size) const {
        const hid_t file = H5Fopen((folder_ / "case" / name).c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        EXPECT_GE(H5Ldelete(file, dataset.c_str(), H5P_DEFAULT), 0);
        const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
        const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
        EXPECT_GE(H5Pset_external(made, (folder_ / other).c_str(), 0, H5F_UNLIMITED), 0);
        H5Dclose(H5Dcreate2(file, dataset.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, made,
                            H5P_DEFAULT));
        H5Pclose(made);
        H5Sclose(space);
        H5Fclose(file);
    }

    /// No store and no message has what the other file holds.
    void expect_held_back(const std::string& source) {
        if (!kernel_has_landlock())
            GTEST_SKIP() << "this kernel has no Landlock";
        for (const std::string& option :
             {std::string("--confined"), "--secret=" + (folder_ / "other").string()}) {
            const auto outcome = run(source, {option});
            EXPECT_EQ(outcome.status, 1) << source << " " << option;
            EXPECT_EQ(outcome.errors.find(word), std::string::npos) << outcome.errors;
            EXPECT_EQ(outcome.errors.find(folder_.path().string()), std::string::npos)
                << outcome.errors;
            fs::remove_all(store());
        }
    }
};

TEST_F(HdfLinks, OutOfAVtkhdfFileAreFollowedOnlyForWhoTrustsThem) {
    write_image(folder_ / "case/flow.vtkhdf", 0);
    link_out("flow.vtkhdf", "/VTKHDF/PointData/U");
    const auto trusted = run("case/flow.vtkhdf");
    EXPECT_EQ(trusted.status, 0) << trusted.errors;
    fs::remove_all(store());
    expect_held_back("case/flow.vtkhdf");
}

TEST_F(HdfLinks, OfTheWholeGroupOfAVtkhdfFileAreFollowedOnlyForWhoTrustsThem) {
    write_image(folder_ / "case/flow.vtkhdf", 0);
    link_out("flow.vtkhdf", "/VTKHDF");
    const auto trusted = run("case/flow.vtkhdf");
    EXPECT_EQ(trusted.status, 0) << trusted.errors;
    fs::remove_all(store());
    expect_held_back("case/flow.vtkhdf");
}

TEST_F(HdfLinks, ToBytesOfAFileOfAnyFormatAreFollowedOnlyForWhoTrustsThem) {
    write_image(folder_ / "case/flow.vtkhdf", 0);
    take_bytes_of("other/token", "flow.vtkhdf", "/VTKHDF/PointData/U", {6, 5, 4, 3});
    const auto trusted = run("case/flow.vtkhdf");
    EXPECT_EQ(trusted.status, 0) << trusted.errors;
    fs::remove_all(store());
    expect_held_back("case/flow.vtkhdf");
}

TEST_F(HdfLinks, OutOfANetcdfFileAreNotReadByWhoDoesNotTrustThem) {
    Flow flow;
    flow.format = NC_NETCDF4;
    write_flow(folder_ / "case/flow.nc", flow);
    EXPECT_EQ(run("case/flow.nc", {"--confined"}).status, 0);
    fs::remove_all(store());
    link_out("flow.nc", "/u");
    expect_held_back("case/flow.nc");
}

} // namespace
} // namespace wakesurf::importer::hdf_links_test
