// Exodus II files through vtkExodusIIReader: which of them are one dataset, and one file of it.
#pragma once

#include "core/base/result.hpp"
#include "importer/base/source.hpp"
#include "importer/sources/files/source_files.hpp"

#include <vtkExodusIIReader.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Parts of a file's name, which tell the files of one dataset: run.e, run.e-s002, run.e-s003 continue one another;
/// run.e.2.0 and run.e.2.1 are the two pieces of one, as parallel programs write them.
struct ExodusName {
    std::string base;     ///< run.e
    unsigned restart = 1; ///< 2 of -s002
    unsigned pieces = 0;  ///< 0: not in pieces
    unsigned piece = 0;
    std::string of_restart{}; ///< "-s002"; empty for the first
};

/// Takes a file's name apart; what has no such ending is its own base.
ExodusName exodus_name(const std::string& name);

struct ExodusSet {
    std::string name;                          ///< of the dataset
    std::vector<std::vector<NamedFile>> parts; ///< the pieces of each restart, in order
    std::string note;                          ///< on a restart that is missing
};

/// Finds the files that belong together with one of them. @param alone  no other restarts. Error: NotFound
/// naming a piece that is missing, Io.
core::Result<ExodusSet> find_exodus_set(const std::filesystem::path& path, bool alone);

/// Reads the time-steps of one file and keeps the mesh between them. Not thread-safe.
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
