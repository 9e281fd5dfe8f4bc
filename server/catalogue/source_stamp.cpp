#include "server/catalogue/source_stamp.hpp"

#include "core/base/disk.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace wakesurf::server {

namespace fs = std::filesystem;

namespace {

class Fingerprint {
  public:
    void add(std::string_view text) {
        for (const char c : text)
            add_byte(static_cast<unsigned char>(c));
    }

    void add(std::uint64_t number) {
        for (int shift = 0; shift < 64; shift += 8)
            add_byte(static_cast<unsigned char>(number >> shift));
    }

    std::uint64_t value() const { return value_; }

  private:
    void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3u; } // FNV-1a

    std::uint64_t value_ = 0xcbf29ce484222325u;
};

void add_listing(Fingerprint& print, const fs::path& folder, bool folders_too) {
    std::error_code error;
    std::vector<fs::path> entries;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        entries.push_back(it->path());
    std::sort(entries.begin(), entries.end());
    const core::PosixDisk disk;
    for (const fs::path& entry : entries) {
        print.add(entry.filename().string());
        if (const auto identity = disk.identity(entry)) {
            print.add(identity->size);
            print.add(static_cast<std::uint64_t>(identity->modified));
        } else if (folders_too && fs::is_directory(entry, error)) {
            add_listing(print, entry, false);
        }
        error.clear();
    }
}

} // namespace

std::uint64_t source_stamp(const fs::path& source) {
    Fingerprint print;
    std::error_code error;
    const bool folder = fs::is_directory(source, error);
    add_listing(print, folder ? source : source.parent_path(), true);
    return print.value();
}

} // namespace wakesurf::server
