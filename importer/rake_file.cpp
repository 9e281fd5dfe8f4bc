#include "importer/rake_file.hpp"

#include "importer/base/text.hpp"
#include "importer/sources/vtk/vtk_file.hpp"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::Vec3;

namespace {

using Points = std::vector<Vec3>;

constexpr std::size_t most_points = 100'000;
constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;

constexpr std::string_view blanks = " \t";

std::string_view separator_of(std::string_view row) {
    return row.find(';') != std::string_view::npos   ? ";"
           : row.find(',') != std::string_view::npos ? ","
                                                     : blanks;
}

// Returns the words of a row, without their quotes; between blanks none is empty.
std::vector<std::string_view> words_of(std::string_view row, std::string_view between) {
    std::vector<std::string_view> words;
    while (true) {
        const auto end = row.find_first_of(between);
        auto word = row.substr(0, end);
        const auto first = word.find_first_not_of(" \t\r\"");
        const auto last = word.find_last_not_of(" \t\r\"");
        word = first == std::string_view::npos ? "" : word.substr(first, last - first + 1);
        if (between != blanks || !word.empty())
            words.push_back(word);
        if (end == std::string_view::npos)
            return words;
        row.remove_prefix(end + 1);
    }
}

std::optional<double> number_of(std::string_view word) {
    if (word.starts_with('+'))
        word.remove_prefix(1);
    double value = 0.0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = fault == std::errc() && end == word.data() + word.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// Returns the axis of a column by its name: x, "X [m]", Points:0, "Points_0", coordinate_x.
std::optional<std::size_t> axis_of(std::string_view word) {
    std::string name = lower_case(std::string(word));
    name.erase(std::min(name.find_first_of("[("), name.size()));
    while (!name.empty() && name.back() == ' ')
        name.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string letter(1, "xyz"[axis]);
        const std::string number(1, "012"[axis]);
        if (name == letter || name == "points:" + number || name == "points_" + number ||
            name == "coordinate_" + letter || name == "coordinate" + letter)
            return axis;
    }
    return std::nullopt;
}

// Returns the columns of x, y and z by a row of names.
std::optional<std::array<std::size_t, 3>> columns_of(const std::vector<std::string_view>& names) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::array<std::size_t, 3> columns{none, none, none};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const auto axis = axis_of(names[i]); axis && columns[*axis] == none)
            columns[*axis] = i;
    for (const std::size_t column : columns)
        if (column == none)
            return std::nullopt;
    return columns;
}

core::Result<Points> too_many(const std::string& name) {
    return core::fail(Error::Code::OverLimit,
                      name + " has more than " + std::to_string(most_points) + " points",
                      "leave some of them out");
}

core::Result<Points> read_table(const std::filesystem::path& path, const std::string& name) {
    std::ifstream in(path);
    if (!in)
        return core::fail(Error::Code::Io, name + " cannot be read");
    std::array<std::size_t, 3> columns{0, 1, 2};
    Points points;
    std::string row;
    bool begun = false;
    for (std::size_t number = 1; std::getline(in, row); ++number) {
        if (number == 1 && row.starts_with("\xef\xbb\xbf"))
            row.erase(0, 3);
        if (row.starts_with('#') || row.find_first_not_of(" \t\r,;") == std::string::npos)
            continue;
        const auto words = words_of(row, separator_of(row));
        if (!std::exchange(begun, true) && !number_of(words.front())) {
            const auto named = columns_of(words);
            if (!named)
                return core::fail(Error::Code::Corrupt,
                                  name + " has no columns x, y and z in its first row",
                                  "name them so, or leave the row of names out");
            columns = *named;
            continue;
        }
        std::array<double, 3> xyz{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto value =
                columns[axis] < words.size() ? number_of(words[columns[axis]]) : std::nullopt;
            if (!value)
                return core::fail(Error::Code::Corrupt,
                                  name + " has no three numbers in row " + std::to_string(number),
                                  "write x, y and z, with a point before decimals");
            xyz[axis] = *value;
        }
        points.emplace_back(xyz[0], xyz[1], xyz[2]);
        if (points.size() > most_points)
            return too_many(name);
    }
    return points;
}

// Returns the place in `count` points that a reference names: 1 is the first, -1 the last, 3/1/2 the third.
std::optional<vtkIdType> place_of(std::string_view reference, vtkIdType count) {
    const auto number = number_of(reference.substr(0, reference.find('/')));
    if (!number || *number != std::trunc(*number) || std::abs(*number) < 1.0 ||
        std::abs(*number) > static_cast<double>(count))
        return std::nullopt;
    const auto place = static_cast<vtkIdType>(*number);
    return place > 0 ? place - 1 : count + place;
}

// Not by vtkOBJReader, which rounds points to single precision.
core::Result<vtkSmartPointer<vtkPolyData>> read_obj(const ListedFile& file) {
    std::ifstream in(file.path);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> faces;
    std::string row;
    for (std::size_t number = 1; std::getline(in, row); ++number) {
        const auto words = words_of(row, blanks);
        if (words.empty() || (words[0] != "v" && words[0] != "l" && words[0] != "f"))
            continue;
        std::vector<vtkIdType> named;
        std::vector<double> numbers;
        bool broken = false;
        for (const auto& word : std::span(words).subspan(1)) {
            if (const auto value = words[0] == "v" ? number_of(word) : std::nullopt)
                numbers.push_back(*value);
            else if (const auto place = place_of(word, points->GetNumberOfPoints()))
                named.push_back(*place);
            else
                broken = true;
        }
        if (broken || (words[0] == "v" ? numbers.size() < 3 : named.size() < 2))
            return core::fail(Error::Code::Corrupt, file.name + " has no " +
                                                        (words[0] == "v" ? "point" : "line") +
                                                        " in row " + std::to_string(number));
        if (words[0] == "v")
            points->InsertNextPoint(numbers.data());
        else
            (words[0] == "l" ? lines : faces)
                ->InsertNextCell(static_cast<vtkIdType>(named.size()), named.data());
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    data->SetPolys(faces);
    return data;
}

core::Result<vtkSmartPointer<vtkPolyData>> read_drawing(const ListedFile& file,
                                                        const std::string& extension) {
    if (extension == ".obj")
        return read_obj(file);
    auto read = extension == ".vtp" ? read_xml_file(file, {}) : read_legacy_file(file);
    if (!read)
        return tl::unexpected(read.error());
    auto* data = vtkPolyData::SafeDownCast(read->data);
    if (data == nullptr)
        return core::fail(Error::Code::Unsupported, file.name + " holds no lines or points",
                          "save the line as .vtp or .csv");
    return vtkSmartPointer<vtkPolyData>(data);
}

// Returns the segments and lines joined where they meet.
vtkSmartPointer<vtkPolyData> joined(vtkPolyData& data) {
    vtkNew<vtkCleanPolyData> clean;
    clean->SetInputData(&data);
    clean->SetTolerance(0.0);
    vtkNew<vtkStripper> stripper;
    stripper->SetInputConnection(clean->GetOutputPort());
    stripper->SetMaximumLength(static_cast<int>(most_points));
    stripper->JoinContiguousSegmentsOn();
    stripper->Update();
    return stripper->GetOutput();
}

core::Result<Points> points_of(vtkPolyData& read, const std::string& name, bool separate) {
    if (read.GetNumberOfPolys() > 0 || read.GetNumberOfStrips() > 0)
        return core::fail(Error::Code::Unsupported, name + " holds faces",
                          "a rake is one line, or separate points");
    vtkSmartPointer<vtkPolyData> data = &read;
    if (!separate && data->GetNumberOfLines() > 1)
        data = joined(read);
    if (!separate && data->GetNumberOfLines() > 1)
        return core::fail(Error::Code::InvalidArgument,
                          name + " holds " + std::to_string(data->GetNumberOfLines()) +
                              " separate lines",
                          "save one of them, or take their points with --rake-kind points");
    vtkNew<vtkIdList> order;
    if (!separate && data->GetNumberOfLines() == 1) {
        data->GetLines()->InitTraversal();
        data->GetLines()->GetNextCell(order);
    } else {
        for (vtkIdType i = 0; i < std::min<vtkIdType>(data->GetNumberOfPoints(), most_points + 1);
             ++i)
            order->InsertNextId(i);
    }
    if (static_cast<std::size_t>(order->GetNumberOfIds()) > most_points)
        return too_many(name);
    Points points;
    for (const vtkIdType id : *order) {
        std::array<double, 3> p{};
        data->GetPoint(id, p.data());
        points.emplace_back(p[0], p[1], p[2]);
        if (!core::finite(points.back()))
            return core::fail(Error::Code::Corrupt, name + " has a point that is not finite");
    }
    return points;
}

} // namespace

core::Result<Points> read_rake_file(const std::filesystem::path& path, bool separate) {
    const std::string name = path.filename().string();
    std::error_code unknown;
    const auto size = std::filesystem::file_size(path, unknown);
    if (unknown || !std::filesystem::is_regular_file(path, unknown))
        return core::fail(Error::Code::NotFound, name + " is not there, or is not a file");
    if (size > most_bytes)
        return core::fail(Error::Code::OverLimit, name + " is too large for a rake: it has " +
                                                      std::to_string(size >> 20) + " MiB");
    const std::string extension = lower_extension(path);
    core::Result<Points> points = tl::unexpected(
        Error{Error::Code::Unsupported, name + " is of a format that a rake cannot be read from",
              "save it as .csv, .txt, .vtp, .vtk or .obj"});
    if (extension == ".csv" || extension == ".txt")
        points = read_table(path, name);
    else if (extension == ".vtp" || extension == ".vtk" || extension == ".obj")
        points = read_drawing({path, name, {}}, extension).and_then([&](const auto& data) {
            return points_of(*data, name, separate);
        });
    if (!points)
        return points;
    points->erase(std::unique(points->begin(), points->end()), points->end());
    if (points->size() < 2)
        return core::fail(Error::Code::Corrupt,
                          name + " has " + (points->empty() ? "no point" : "only one point"),
                          "a rake needs at least two");
    return points;
}

} // namespace wakesurf::importer
