#include "importer/sources/vtk/legacy_gaps.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string_view>

namespace wakesurf::importer {

namespace {

// A number that no one computes, in 32 bits too.
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

// A line of numbers begins with one; others name something, which may be called anything.
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

} // namespace

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

void unmark_gaps(vtkDataSet& data) {
    const auto each = [](vtkDataArray* array) {
        if (array != nullptr && array->GetDataType() == VTK_FLOAT)
            unmark(*array, static_cast<double>(std::stof(mark_text)));
        else if (array != nullptr && array->GetDataType() == VTK_DOUBLE)
            unmark(*array, std::stod(mark_text));
    };
    if (auto* set = vtkPointSet::SafeDownCast(&data); set != nullptr && set->GetPoints() != nullptr)
        each(set->GetPoints()->GetData());
    for (vtkDataSetAttributes* fields : {static_cast<vtkDataSetAttributes*>(data.GetPointData()),
                                         static_cast<vtkDataSetAttributes*>(data.GetCellData())})
        for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
            each(fields->GetArray(i));
}

} // namespace wakesurf::importer
