#include "importer/rake_file.hpp"
#include "tests/importer/vtk_files.hpp"

#include <vtkCellArray.h>
#include <vtkPolyData.h>

#include <initializer_list>

namespace wakesurf::importer::rake_file_test {

using core::Vec3;
using Points = std::vector<Vec3>;

class RakeFile : public tests::VtkFiles {
  protected:
    Points read(const std::string& name, const std::string& text, bool separate = false) const {
        const auto points = read_rake_file(put(name, text), separate);
        EXPECT_TRUE(points) << name << ": " << (points ? "" : points.error().message);
        return points.value_or(Points());
    }

    std::string
    complaint(const std::string& name, const std::string& text, bool separate = false) const {
        const auto points = read_rake_file(put(name, text), separate);
        return points ? "none" : points.error().message;
    }
};

const Points three{{0, 0, 0}, {1, 0.5, 0}, {2, 0.5, -3e-2}};

TEST_F(RakeFile, ATableHasItsColumnsByNameOrInOrder) {
    EXPECT_EQ(read("a.csv", "0,0,0\n1,0.5,0\n2,.5,-3e-2\n"), three);
    EXPECT_EQ(read("b.txt", "# metres\n\n 0 0\t0\r\n1 0.5 0\r\n+2 0.5 -0.03\r\n"), three);
    EXPECT_EQ(
        read("c.CSV", "\xef\xbb\xbfid;Z [m];X [m];Y [m]\n1;0;0;0\n2;0;1;0.5\n3;-0.03;2;0.5\n"),
        three);
    EXPECT_EQ(read("d.csv", "\"U:0\",\"Points:0\",\"Points:1\",\"Points:2\"\n9,0,0,0\n"
                            "9,1,0.5,0\n9,2,0.5,-0.03\n"),
              three);
}

TEST_F(RakeFile, ATableThatHoldsSomethingElseIsRefusedByRow) {
    EXPECT_EQ(complaint("a.csv", "x,y\n0,0\n"), "a.csv has no columns x, y and z in its first row");
    EXPECT_EQ(complaint("a.csv", "x,y,z\n0,0,0\n1,0\n"), "a.csv has no three numbers in row 3");
    EXPECT_EQ(complaint("a.csv", "0;0;0\n0,5;0;0\n"), "a.csv has no three numbers in row 2");
    EXPECT_EQ(complaint("a.csv", "0,0,0\n1,inf,0\n"), "a.csv has no three numbers in row 2");
    EXPECT_EQ(complaint("a.csv", ""), "a.csv has no point");
    EXPECT_EQ(complaint("a.csv", "0,0,0\n0,0,0\n"), "a.csv has only one point");
    EXPECT_EQ(complaint("a.stl", "solid"), "a.stl is of a format that a rake cannot be read from");
    std::string long_table;
    for (int i = 0; i <= 100'000; ++i)
        long_table += std::to_string(i) + ",0,0\n";
    EXPECT_EQ(complaint("a.csv", long_table), "a.csv has more than 100000 points");
    EXPECT_EQ(read_rake_file("nowhere.csv", false).error().message,
              "nowhere.csv is not there, or is not a file");
}

TEST_F(RakeFile, AnObjIsItsOneLineInTheOrderOfTheLine) {
    const std::string nodes = "v 1 0.5 0\nv 2 0.5 -0.03\nv 0 0 0\n";
    EXPECT_EQ(read("a.obj", nodes + "l 3 1 2\n"), three);
    EXPECT_EQ(read("a.obj", "o curve\n" + nodes + "vn 0 0 1\nl -1/1 -3 2\n"), three);
    EXPECT_EQ(complaint("a.obj", nodes + "l 1 4\n"), "a.obj has no line in row 4");
    EXPECT_EQ(complaint("a.obj", "v 1 2\n"), "a.obj has no point in row 1");
    EXPECT_EQ(read("b.obj", nodes + "l 3 1\nl 1 2\n").size(), 3u); // two segments that meet
    EXPECT_EQ(read("c.obj", nodes, true).size(), 3u);
    EXPECT_EQ(complaint("d.obj", nodes + "f 1 2 3\n"), "d.obj holds faces");
    const std::string apart = nodes + "v 5 5 5\nl 1 2\nl 3 4\n";
    EXPECT_EQ(complaint("e.obj", apart), "e.obj holds 2 separate lines");
    EXPECT_EQ(read("e.obj", apart, true).size(), 4u);
}

TEST_F(RakeFile, AVtpIsItsLineOrElseItsPoints) {
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    for (const std::size_t i : {1u, 0u, 2u})
        places->InsertNextPoint(three[i].x, three[i].y, three[i].z);
    vtkNew<vtkPolyData> data;
    data->SetPoints(places);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({1, 0, 2});
    data->SetLines(lines);
    const auto line = read_rake_file(write("a.vtp", *data), false);
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_EQ(*line, three);
    EXPECT_EQ(complaint("b.vtp", "<VTKFile type=\"PolyData\""),
              "b.vtp is truncated or not a VTK XML file");
}

} // namespace wakesurf::importer::rake_file_test
