// One Exodus II file through vtkExodusIIReader: a dataset is one, or several of them.
#pragma once

#include "importer/base/source.hpp"
#include "importer/sources/files/source_files.hpp"

#include <vtkExodusIIReader.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::importer {

/// Reads time-steps and keeps the mesh between them. Not thread-safe.
class ExodusFile {
  public:
    explicit ExodusFile(NamedFile file) : file_(std::move(file)) {}

    const NamedFile& file() const { return file_; }

    /// Returns its times. Error: NotFound, Io, Corrupt, OverLimit.
    core::Result<std::vector<double>> open();

    /// Gives its memory back; reading opens it again.
    void close() { reader_ = nullptr; }

    /// Returns the names of displacements. REQUIRES: open().
    std::vector<std::string> displacements() const;

    /// Returns blocks of the element blocks of three dimensions, and walls of side sets and flat blocks called
    /// wall. @param fields  null: all. @param plane  returns the slabs of flat element blocks only, and their third
    /// components without being asked
    core::Result<SourceStep>
    read(std::size_t step, const std::vector<core::FieldInfo>* fields, bool plane);

    /// Names a time-step in messages.
    std::string step_name(std::size_t step) const;

  private:
    core::Result<void> open_reader();
    core::Result<void> check_sizes() const;
    void choose_fields(const std::vector<core::FieldInfo>* fields);
    tl::unexpected<core::Error> give_up(core::Error error);
    core::Result<SourceStep> take(const std::vector<core::FieldInfo>* fields, bool plane) const;

    NamedFile file_;
    vtkSmartPointer<vtkExodusIIReader> reader_;
};

} // namespace wakesurf::importer
