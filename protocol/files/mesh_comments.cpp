#include "protocol/files/mesh_comments.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/files/number_text.hpp"

#include <cctype>

namespace wakesurf::protocol {

namespace {

std::string points_text(const std::vector<core::Vec3>& points) {
    std::string out;
    for (const core::Vec3& p : points)
        out += (out.empty() ? "" : " ") + number_text(p.x) + "," + number_text(p.y) + "," +
               number_text(p.z);
    return out;
}

std::string printable(std::string text) {
    for (char& c : text)
        if (std::iscntrl(static_cast<unsigned char>(c)) != 0)
            c = ' ';
    return text;
}

} // namespace

std::vector<std::string> mesh_comments(const MeshMetadata& metadata) {
    std::vector<std::string> lines{
        "wakesurf " + printable(metadata.version), "kind " + std::string(name(metadata.kind)),
        "dataset " + printable(metadata.dataset), "rake " + points_text(metadata.rake)};
    if (tells_kind(metadata.rake_kind))
        lines.push_back("rakeKind " + std::string(name(metadata.rake_kind)));
    if (!metadata.rake2.empty())
        lines.push_back("rake2 " + points_text(metadata.rake2));
    if (tells_kind(metadata.rake2_kind))
        lines.push_back("rake2Kind " + std::string(name(metadata.rake2_kind)));
    if (metadata.sweep)
        lines.push_back("sweep " + points_text({*metadata.sweep}));
    lines.push_back("from " + number_text(metadata.from));
    lines.push_back("to " + number_text(metadata.to));
    if (metadata.time)
        lines.push_back("time " + number_text(*metadata.time));
    if (metadata.release_until)
        lines.push_back("releaseUntil " + number_text(*metadata.release_until));
    lines.push_back("separation " + number_text(metadata.separation));
    if (!metadata.stopped.empty())
        lines.push_back("stopped " + printable(metadata.stopped));
    return lines;
}

} // namespace wakesurf::protocol
