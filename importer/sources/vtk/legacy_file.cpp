#include "importer/sources/vtk/legacy_file.hpp"

#include "importer/base/process_memory.hpp"
#include "importer/base/vtk_messages.hpp"
#include "importer/sources/files/file_names.hpp"
#include "importer/sources/vtk/legacy_gaps.hpp"

#include <vtkGenericDataObjectReader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Error;

namespace {

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

/// Numbers behind a word that stands at the beginning of a line.
std::vector<std::uint64_t> numbers_behind(const std::string& line, std::string_view word) {
    std::vector<std::uint64_t> out;
    if (!line.starts_with(word))
        return out;
    std::istringstream in(line.substr(word.size()));
    for (std::uint64_t number = 0; in >> number;)
        out.push_back(number);
    return out;
}

// VTK's reader looks for words in what is left of a file whose arrays it has no memory for, which takes hours where that is long.
core::Result<void> check_size(const ListedFile& file) {
    constexpr std::size_t header_bytes = 4096;
    constexpr std::uint64_t bytes_a_node = 12; // a velocity, or a place
    std::string header(header_bytes, '\0');
    std::ifstream in(file.path, std::ios::binary);
    in.read(header.data(), static_cast<std::streamsize>(header.size()));
    header.resize(static_cast<std::size_t>(in.gcount()));
    std::istringstream lines(header);
    bool binary = false;
    for (std::string line; std::getline(lines, line);) {
        binary = binary || line.starts_with("BINARY");
        const auto dimensions = numbers_behind(line, "DIMENSIONS");
        const auto points = numbers_behind(line, "POINTS");
        std::uint64_t nodes = points.empty() ? 1 : points.front();
        for (const std::uint64_t n : dimensions)
            if (auto fits = check_claim(file.name, std::max<std::uint64_t>(n, 1), nodes); !fits)
                return fits;
            else
                nodes *= std::max<std::uint64_t>(n, 1);
        if (auto fits = check_claim(file.name, nodes, bytes_a_node); !fits)
            return fits;
    }
    // As a whole, and as it is: that is what the reader does.
    std::error_code error;
    const auto size = std::filesystem::file_size(file.path, error);
    return binary && !error ? check_claim(file.name, size, 1) : core::Result<void>();
}

} // namespace

core::Result<VtkFile> read_legacy_file(const ListedFile& file) {
    if (auto whole = check_last_number(file); !whole)
        return tl::unexpected(whole.error());
    if (auto fits = check_size(file); !fits)
        return tl::unexpected(fits.error());
    const VtkMessages messages;
    auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
    reader->SetFileName(file.path.c_str());
    std::ifstream in(file.path, std::ios::binary);
    std::string encoding;
    for (int line = 0; line < 3; ++line)
        std::getline(in, encoding);
    std::optional<std::string> marked;
    try {
        if (!encoding.starts_with("BINARY"))
            marked = with_marked_gaps(in);
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to read " + file.name);
    }
    if (marked) {
        reader->SetInputString(*marked);
        reader->ReadFromInputStringOn();
    }
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllNormalsOn();
    try {
        reader->Update();
    } catch (const std::bad_alloc&) {
        return core::fail(Error::Code::OverLimit,
                          "there is not enough memory to read " + file.name);
    }
    if (auto clean = messages.verdict(file.name); !clean)
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
    std::transform(title.begin(), title.end(), title.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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
