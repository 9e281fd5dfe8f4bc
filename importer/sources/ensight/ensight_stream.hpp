// One EnSight Gold file as a run of lines, whole numbers and numbers, whichever of its three encodings it is
// in. (VTK's readers of the format do not notice where a file ends: they repeat the last number they saw.)
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/files/source_files.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

class EnsightStream {
  public:
    /// Reads the whole file. Error: NotFound, Io, OverLimit (memory).
    static core::Result<EnsightStream> open(const NamedFile& file);

    /// Geometry files state whether they are binary; variables have the encoding of their geometry.
    enum class Encoding { Text, CBinary, FortranBinary };
    /// Detects the encoding of a geometry file, and skips the first line if that names one.
    Encoding detect();

    void set_encoding(Encoding encoding, bool swapped) {
        encoding_ = encoding;
        swapped_ = swapped;
    }

    bool swapped() const { return swapped_; }

    std::size_t size() const { return text_.size(); } ///< of the file in bytes

    /// Says whether only space is left.
    bool at_end();
    /// The functions below return Corrupt, naming the file, if it ends too early or holds something else.
    core::Result<std::string> line();
    core::Result<std::vector<std::int32_t>> integers(std::size_t count);
    core::Result<std::vector<float>> numbers(std::size_t count);
    /// Reads a whole number of at least 0. The first one in a file decides on the order of its bytes.
    core::Result<std::size_t> count();

    /// Steps back before the line read last.
    void unread_line() { at_ = before_line_; }

    tl::unexpected<core::Error> damaged(const std::string& what) const;

  private:
    template <class T>
    core::Result<std::vector<T>> values(std::size_t count);
    core::Result<std::string_view> bytes(std::size_t count);
    core::Result<std::string_view> word();

    std::string name_;
    std::string text_;
    std::size_t at_ = 0;
    std::size_t before_line_ = 0;
    Encoding encoding_ = Encoding::Text;
    bool swapped_ = false;
    bool order_known_ = false;
};

} // namespace wakesurf::importer
