#include "server/app/whole_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace wakesurf::server {

core::Result<void> write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
    const auto failed = [&](int why) {
        return core::fail(core::Error::Code::Io,
                          "cannot write " + file.string() + ": " +
                              std::generic_category().message(why),
                          "name a file in an existing folder with enough room");
    };
    auto part = file;
    part += ".part";
    errno = 0;
    std::ofstream stream(part, std::ios::binary | std::ios::trunc);
    if (!stream)
        return failed(errno);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    std::error_code renamed;
    if (stream)
        std::filesystem::rename(part, file, renamed);
    if (stream && !renamed)
        return {};
    const int why = renamed ? renamed.value() : errno;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    return failed(why);
}

} // namespace wakesurf::server
