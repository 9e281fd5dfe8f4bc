#include "importer/sources/files/source_files.hpp"

#include "core/base/disk.hpp"

namespace wakesurf::importer {

core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<NamedFile>& files) {
    std::vector<store::SourceFile> out;
    out.reserve(files.size());
    const core::PosixDisk disk;
    for (const auto& file : files) {
        const auto found = disk.identity(file.path);
        if (!found && found.error().code == core::Error::Code::NotFound)
            return core::fail(found.error().code, file.name + " is not there");
        if (!found)
            return tl::unexpected(found.error());
        out.push_back({file.name, found->size, found->modified});
    }
    return out;
}

} // namespace wakesurf::importer
