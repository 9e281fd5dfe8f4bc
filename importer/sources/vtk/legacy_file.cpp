#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/vtk/vtk_file.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Error;

namespace {

// Handles numbers that are none, as text in legacy files: "nan" and "inf", which VTK's reader takes for
// damage.

// A number that no program computes, in 32 bits too, marks them.
constexpr const char* mark_text = "-1.4703134148e+38";

bool is_gap(std::string_view word) {
    std::string plain;
    for (const char c : word)
        plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (plain.starts_with('-') || plain.starts_with('+'))
        plain.erase(0, 1);
    constexpr std::array<std::string_view, 3> words{"nan", "inf", "infinity"};
    return std::find(words.begin(), words.end(), plain) != words.end() || plain.starts_with("nan(");
}

bool is_blank(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// Calls visit(blank, word) for every word of a line and the blanks before it; "" behind the last.
template <class Visit>
void visit_words(std::string_view line, const Visit& visit) {
    std::size_t at = 0;
    while (at <= line.size()) {
        std::size_t begin = at;
        while (begin < line.size() && is_blank(line[begin]))
            ++begin;
        std::size_t end = begin;
        while (end < line.size() && !is_blank(line[end]))
            ++end;
        visit(line.substr(at, begin - at), line.substr(begin, end - begin));
        at = end + (end == line.size() ? 1 : 0);
    }
}

// A line of numbers begins with one; others name something, by any text.
bool has_gaps(std::string_view line) {
    bool numbers = false;
    bool first = true;
    bool any = false;
    visit_words(line, [&](std::string_view, std::string_view word) {
        if (word.empty())
            return;
        const bool gap = is_gap(word);
        if (first)
            numbers = gap || std::string_view("+-.0123456789").find(word[0]) != std::string::npos;
        first = false;
        any = any || gap;
    });
    return numbers && any;
}

void unmark(vtkDataArray& array, double as_stored) {
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
        for (int c = 0; c < array.GetNumberOfComponents(); ++c)
            if (array.GetComponent(i, c) == as_stored)
                array.SetComponent(i, c, std::numeric_limits<double>::quiet_NaN());
}

// Returns the text with a mark in place of every such word among numbers. Empty if there are none, which is
// found without keeping the text.
std::optional<std::string> with_marked_gaps(std::istream& in) {
    std::string line;
    bool any = false;
    while (!any && std::getline(in, line))
        any = has_gaps(line);
    if (!any)
        return std::nullopt;
    in.clear();
    in.seekg(0);
    std::string out;
    while (std::getline(in, line)) {
        if (has_gaps(line))
            visit_words(line, [&](std::string_view blank, std::string_view word) {
                out += blank;
                out += is_gap(word) ? std::string_view(mark_text) : word;
            });
        else
            out += line;
        out += '\n';
    }
    return out;
}

// Replaces the marks by NaN, in points and fields.
void unmark_gaps(vtkDataSet& data) {
    const auto unmark_array = [](vtkDataArray* array) {
        if (array != nullptr && array->GetDataType() == VTK_FLOAT)
            unmark(*array, static_cast<double>(std::stof(mark_text)));
        else if (array != nullptr && array->GetDataType() == VTK_DOUBLE)
            unmark(*array, std::stod(mark_text));
    };
    if (auto* set = vtkPointSet::SafeDownCast(&data); set != nullptr && set->GetPoints() != nullptr)
        unmark_array(set->GetPoints()->GetData());
    for (vtkDataSetAttributes* fields : {static_cast<vtkDataSetAttributes*>(data.GetPointData()),
                                         static_cast<vtkDataSetAttributes*>(data.GetCellData())})
        for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
            unmark_array(fields->GetArray(i));
}

// A text that was cut in its last number would give another number.
core::Result<void> check_last_number(const ListedFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    std::string version, title, encoding;
    if (!std::getline(in, version) || !std::getline(in, title) || !std::getline(in, encoding) ||
        !version.starts_with("# vtk DataFile"))
        return core::fail(Error::Code::Corrupt, file.name + " is not a legacy VTK file");
    if (encoding.starts_with("BINARY"))
        return {};
    in.clear();
    in.seekg(-1, std::ios::end);
    if (const int last = in.get(); last != '\n' && last != ' ' && last != '\r' && last != '\t')
        return core::fail(Error::Code::Corrupt,
                          file.name + " is truncated: it does not end with a line break",
                          "end the file with a line break if it is whole");
    return {};
}

} // namespace

core::Result<VtkFile> read_legacy_file(const ListedFile& file) {
    if (auto whole = check_last_number(file); !whole)
        return tl::unexpected(whole.error());
    const VtkMessages messages;
    auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
    reader->SetFileName(file.path.c_str());
    std::ifstream in(file.path, std::ios::binary);
    std::string encoding;
    for (int line = 0; line < 3; ++line)
        std::getline(in, encoding);
    const bool binary = encoding.starts_with("BINARY");
    // VTK's reader reads a binary file as a whole. Where it has no memory for an array it searches the rest for words, 15 ms a MiB.
    std::error_code error;
    if (const auto size = std::filesystem::file_size(file.path, error); binary && !error)
        if (auto fits = check_claim(file.name, size, 1); !fits)
            return tl::unexpected(fits.error());
    std::optional<std::string> marked;
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllNormalsOn();
    const auto update = [&] {
        if (!binary)
            marked = with_marked_gaps(in);
        if (marked) {
            reader->SetInputString(*marked);
            reader->ReadFromInputStringOn();
        }
        reader->Update();
        return messages.verdict(file.name);
    };
    if (auto clean = within_memory(file.name, update); !clean)
        return tl::unexpected(clean.error());
    vtkSmartPointer<vtkDataSet> data = vtkDataSet::SafeDownCast(reader->GetOutput());
    if (data == nullptr)
        return core::fail(Error::Code::Unsupported, file.name + " holds no grid");
    if (marked)
        unmark_gaps(*data);
    return VtkFile{data, "vtkGenericDataObjectReader"};
}

std::optional<double> legacy_title_time(const ListedFile& file) {
    std::ifstream in(file.path, std::ios::binary);
    std::string version, title;
    if (!std::getline(in, version) || !std::getline(in, title))
        return std::nullopt;
    title = lower_case(title);
    auto at = title.find("time");
    if (at == std::string::npos ||
        (at > 0 && std::isalnum(static_cast<unsigned char>(title[at - 1])) != 0))
        return std::nullopt;
    at = title.find_first_not_of(" \t", at + 4);
    if (at == std::string::npos || (title[at] != '=' && title[at] != ':'))
        return std::nullopt;
    at = title.find_first_not_of(" \t", at + 1);
    if (at == std::string::npos)
        return std::nullopt;
    return finite_number(
        std::string_view(title).substr(at, title.find_first_of(" \t,;\r", at) - at));
}

} // namespace wakesurf::importer
