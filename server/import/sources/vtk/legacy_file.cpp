#include "server/import/sources/vtk/legacy_file.hpp"

#include "server/import/vtk_messages.hpp"

#include <vtkGenericDataObjectReader.h>

#include <fstream>
#include <new>

namespace wakesurf::server {

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

} // namespace

core::Result<VtkFile> read_legacy_file(const ListedFile& file) {
    if (auto whole = check_last_number(file); !whole)
        return tl::unexpected(whole.error());
    const VtkMessages messages;
    auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
    reader->SetFileName(file.path.c_str());
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
    return VtkFile{data, "vtkGenericDataObjectReader"};
}

} // namespace wakesurf::server
