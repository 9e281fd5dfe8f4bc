// Files as users have them, from the file to the mesh: wherever the velocity is exactly (1, A t + B z, C), every vertex of a path
// surface is known. The files are VTK's writer's.
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/known_flow.hpp"

#include <vtkFloatArray.h>

#include <cmath>
#include <sstream>

namespace wakesurf::importer::field_cases_test {
namespace {

constexpr double a = 0.25, b = 0.3, c = 0.2;

using Fill = std::function<void(vtkImageData&)>;

void put_velocity(vtkImageData& image, const char* name, double time, double scale = 1.0) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
        array->InsertNextTuple3(scale, scale * (a * time + b * image.GetPoint(i)[2]), scale * c);
    image.GetPointData()->AddArray(array);
}

void put_scalar(vtkImageData& image, const char* name, double value) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
        array->InsertNextValue(value);
    image.GetPointData()->AddArray(array);
}

class FieldCases : public Import {
  protected:
    void write(const std::string& name, const Fill& fill, std::optional<double> time = {}) const {
        auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetDimensions(9, 9, 9);
        image->SetSpacing(0.25, 0.25, 0.25);
        fill(*image);
        write_timed_image(*image, folder_ / name, time);
    }

    Outcome command(std::vector<std::string> words) const {
        Outcome out;
        const auto done =
            run_child(server_program(), words, 0,
                      [&](std::string_view line) { out.lines.emplace_back(line); }, {});
        out.status = done->exit_status;
        out.errors = done->errors;
        return out;
    }

    // Of a rake along y at x = 0.2, z = 0.5, from y = 0.2 to 0.6; `frozen`: the time that its only time-step is of.
    void expect_exact_surface(const std::string& source,
                              double from,
                              double to,
                              const std::vector<std::string>& options,
                              std::optional<double> frozen = {}) const {
        std::vector<std::string> words{"surface",      folder_ / source,
                                       "--store",      folder_ / "cache",
                                       "--kind",       frozen ? "stream" : "path",
                                       "--rake",       "0.2,0.2,0.5 0.2,0.6,0.5",
                                       "--accuracy",   "exact",
                                       "--separation", "0.1",
                                       "--from",       std::to_string(from),
                                       "--to",         std::to_string(to),
                                       "-o",           folder_ / "s.obj"};
        words.insert(words.end(), options.begin(), options.end());
        const auto outcome = command(words);
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        std::ifstream in(folder_ / "s.obj");
        double least = 9.0, most = -9.0, longest = 0.0;
        for (std::string line; std::getline(in, line);) {
            std::istringstream text(line);
            std::string kind;
            double x = 0.0, y = 0.0, z = 0.0;
            if (!(text >> kind >> x >> y >> z) || kind != "v")
                continue;
            const double age = x - 0.2;
            const double time = from + age;
            const double rises = frozen ? a * *frozen * age : a * (time * time - from * from) / 2;
            const double seed = y - rises - b * (0.5 * age + c * age * age / 2);
            EXPECT_NEAR(z, 0.5 + c * age, 1e-4);
            EXPECT_GT(seed, 0.2 - 1e-4);
            EXPECT_LT(seed, 0.6 + 1e-4);
            least = std::min(least, seed);
            most = std::max(most, seed);
            longest = std::max(longest, age);
        }
        EXPECT_NEAR(least, 0.2, 1e-4);
        EXPECT_NEAR(most, 0.6, 1e-4);
        EXPECT_NEAR(longest, to - from, 1e-4);
    }
};

TEST_F(FieldCases, AGridsVelocityIsNotTheFluids) {
    write("flow.vti", [](vtkImageData& image) {
        put_scalar(image, "Density", 2.5);
        put_velocity(image, "Momentum", 0.0, 2.5);
        put_velocity(image, "Grid_Velocity", 3.0, -1.0);
    });
    expect_exact_surface("flow.vti", 0, 1, {}, 0.0);
}

TEST_F(FieldCases, EveryCommandTakesTheVelocityThatIsMeant) {
    for (int step = 0; step < 3; ++step)
        write("u_" + std::to_string(step) + ".vti", [&](vtkImageData& image) {
            put_velocity(image, "U.air", 7.0 + step);
            put_velocity(image, "U.water", 0.5 * step);
            put_scalar(image, "p", step);
        });
    const std::string file = folder_ / "u_1.vti";
    const std::string words = "several fields could be the velocity: U.air (3 components, point), "
                              "U.water (3 components, point) (choose one with --velocity NAME";
    for (const auto& asking : std::vector<std::vector<std::string>>{
             {"info", file},
             {"import", file, store()},
             {"surface", file, "--kind", "path", "--to", "1", "-o", folder_ / "s.obj", "--store",
              folder_ / "refused"}}) {
        const auto refused = command(asking);
        EXPECT_NE(refused.status, 0);
        EXPECT_NE(refused.errors.find(words), std::string::npos) << refused.errors;
    }
    expect_refusal("u_1.vti", words);
    const auto info = command({"info", file, "--velocity", "U.water"});
    EXPECT_NE(std::find(info.lines.begin(), info.lines.end(),
                        "  velocity  U.water: chosen by --velocity"),
              info.lines.end())
        << info.errors;
    EXPECT_EQ(command({"import", file, store(), "--velocity", "U.water"}).status, 0);
    EXPECT_EQ(manifest().info.velocity, "U.water");
    EXPECT_EQ(run("u_1.vti", {"--velocity=U.air"}).status, 0);
    EXPECT_EQ(manifest().info.velocity, "U.air") << "never the old one in silence";
    expect_exact_surface("u_1.vti", 0, 1, {"--velocity", "U.water", "--dt", "0.5"});
    const auto other = command({"surface", file, "--store", folder_ / "cache", "--kind", "path",
                                "--rake", "0.2,0.2,0.5 0.2,0.6,0.5", "--to", "0.25", "--dt", "0.5",
                                "--velocity", "U.air", "-o", folder_ / "t.obj"});
    EXPECT_EQ(other.status, 0) << other.errors;
    const auto folders = std::distance(fs::directory_iterator(folder_ / "cache"), {});
    EXPECT_EQ(folders, 2) << "each velocity has a store of its own";
    expect_exact_surface("u_1.vti", 0, 1, {"--velocity", "U.water", "--dt", "0.5"});
    for (const auto& wrong : std::vector<std::vector<std::string>>{
             {"info", store(), "--velocity", "U.air"}, {"info", "flow:abc", "--velocity", "u"}}) {
        const auto refused = command(wrong);
        EXPECT_EQ(refused.status, 2);
        EXPECT_NE(refused.errors.find("--velocity chooses among the fields of files"),
                  std::string::npos)
            << refused.errors;
    }
}

TEST_F(FieldCases, ThreeScalarsOfAnyNamesAreAVelocityOnRequest) {
    const auto part = [](vtkImageData& image, const char* name, int component) {
        auto array = vtkSmartPointer<vtkDoubleArray>::New();
        array->SetName(name);
        for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
            array->InsertNextValue(
                std::array{1.0, b * image.GetPoint(i)[2], c}[static_cast<std::size_t>(component)]);
        image.GetPointData()->AddArray(array);
    };
    write("n.vti", [&](vtkImageData& image) {
        part(image, "geschw_x", 0);
        part(image, "geschw_y", 1);
        part(image, "geschw_z", 2);
    });
    expect_refusal("n.vti", "--velocity U,V,W");
    expect_exact_surface("n.vti", 0, 1, {"--velocity", "geschw_x,geschw_y,geschw_z"}, 0.0);
    write("s.vti", [&](vtkImageData& image) {
        part(image, "Velocity[i] (m/s)", 0);
        part(image, "Velocity[j] (m/s)", 1);
        part(image, "Velocity[k] (m/s)", 2);
    });
    expect_exact_surface("s.vti", 0, 1, {}, 0.0);
}

TEST_F(FieldCases, OneOutputOfSeveralIsASeries) {
    for (int step = 0; step < 12; ++step) {
        write("B.out1." + std::to_string(step) + ".vti",
              [&](vtkImageData& image) { put_velocity(image, "vel", 99.0); });
        write("B.out2." + std::to_string(step) + ".vti",
              [&](vtkImageData& image) { put_velocity(image, "vel", 0.1 * step + 0.1); });
    }
    expect_exact_surface("B.out2.10.vti", 0.1, 1.1, {"--dt=0.1", "--start=0.1"});
    const auto alone = command({"info", folder_ / "B.out2.3.vti", "--alone"});
    EXPECT_NE(
        std::find(alone.lines.begin(), alone.lines.end(), "  times     1 from 0 to 0 (steady)"),
        alone.lines.end());
    expect_exact_surface("B.out2.3.vti", 0, 0.5, {"--alone"}, 0.4);
}

TEST_F(FieldCases, ARestartIsReadAsItWasWrittenLast) {
    std::string pvd = "<VTKFile type=\"Collection\"><Collection>";
    std::string listed;
    int number = 0;
    const auto add = [&](double time, bool right) {
        const std::string name = "r_" + std::to_string(number++) + ".vti";
        write(
            name, [&](vtkImageData& image) { put_velocity(image, "U", right ? time : -5.0); },
            time);
        pvd += "<DataSet timestep=\"" + std::to_string(time) + "\" file=\"" + name + "\"/>";
        listed += std::string(listed.empty() ? "" : ",") + "{\"name\":\"" + name +
                  "\",\"time\":" + std::to_string(time) + "}";
    };
    for (const auto& [time, right] : {std::pair{0.0, true},
                                      {0.5, true},
                                      {1.0, false},
                                      {1.5, false},
                                      {1.0, true},
                                      {1.5, true},
                                      {2.0, true}})
        add(time, right);
    put("r.pvd", pvd + "</Collection></VTKFile>");
    put("r.vti.series", "{\"file-series-version\":\"1.0\",\"files\":[" + listed + "]}");
    for (const char* const source : {"r.pvd", "r.vti.series", "r_3.vti"}) {
        expect_exact_surface(source, 0, 1.6, {});
        const auto info = command({"info", folder_ / source, "--json"});
        std::string text;
        for (const auto& line : info.lines)
            text += line;
        EXPECT_NE(text.find("for the same time: r_2.vti, r_3.vti"), std::string::npos) << text;
    }
}

TEST_F(FieldCases, AScalarThatIsNoMaskIsAScalarWhateverItsName) {
    for (const char* const name : {"solid", "Mask", "obstacle", "fluid"}) {
        write("m.vti", [&](vtkImageData& image) {
            put_velocity(image, "U", 0.0);
            put_scalar(image, name, 0.25);
        });
        expect_exact_surface("m.vti", 0, 1, {}, 0.0);
        ASSERT_EQ(run("m.vti").status, 0);
        EXPECT_FALSE(manifest().info.obstacle);
        EXPECT_NE(manifest().info.note.find(std::string(name) + " is a scalar, not a mask"),
                  std::string::npos)
            << manifest().info.note;
        EXPECT_EQ(manifest().layout.scalars.size(), 1u);
    }
    for (int step = 0; step < 2; ++step) // a fraction of 0 and 1 at first
        write("f_" + std::to_string(step) + ".vti", [&](vtkImageData& image) {
            put_velocity(image, "U", step);
            put_scalar(image, "fluid", step == 0 ? 1.0 : 0.75);
        });
    expect_exact_surface("f_0.vti", 0, 1, {});
}

TEST_F(FieldCases, AFolderThatCannotBeMadeForTheStoreIsNamed) {
    write("n.vti", [](vtkImageData& image) { put_velocity(image, "U", 0.0); });
    const auto refused = command({"surface", folder_ / "n.vti", "--kind", "stream", "--store",
                                  folder_ / "n.vti" / "below", "-o", folder_ / "s.obj"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.errors.find("cannot create the store folder in " +
                                  (folder_ / "n.vti" / "below").string()),
              std::string::npos)
        << refused.errors;
    EXPECT_NE(refused.errors.find("with --store"), std::string::npos) << refused.errors;
}

} // namespace
} // namespace wakesurf::importer::field_cases_test
