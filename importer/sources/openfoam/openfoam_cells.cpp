#include "importer/sources/openfoam/openfoam_cells.hpp"

#include "importer/base/process_memory.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::importer {

namespace {

namespace fs = std::filesystem;

using File = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

constexpr std::size_t piece_bytes = std::size_t{1} << 16;

/// A list of labels as it begins: "FoamFile { ... } // comment \n 12 (".
struct ListHead {
    std::int64_t count = 0;
    std::size_t begin = 0; ///< of the labels in the file
    bool binary = false;
    std::size_t label_bytes = 4;
};

std::optional<ListHead> head_of(gzFile in) {
    std::string text(foam_header_bytes, '\0');
    const int got = ::gzread(in, text.data(), static_cast<unsigned>(text.size()));
    if (got <= 0)
        return std::nullopt;
    text.resize(static_cast<std::size_t>(got));
    std::size_t at = text.find('}', text.find("FoamFile"));
    if (at == std::string::npos || text.find("MSB") < at)
        return std::nullopt;
    const std::string_view header = std::string_view(text).substr(0, at);
    ListHead out;
    out.binary = header.find("binary") != std::string_view::npos;
    out.label_bytes = header.find("label=64") != std::string_view::npos ? 8 : 4;
    for (++at; at < text.size(); ++at) {
        if (text.compare(at, 2, "//") == 0)
            at = text.find('\n', at);
        if (at >= text.size() || text.find_first_of("0123456789", at) == at)
            break;
    }
    if (at >= text.size())
        return std::nullopt;
    const auto [end, error] =
        std::from_chars(text.data() + at, text.data() + text.size(), out.count);
    const auto open =
        text.find_first_not_of(" \t\r\n", static_cast<std::size_t>(end - text.data()));
    if (error != std::errc() || open == std::string::npos || text[open] != '(')
        return std::nullopt;
    out.begin = open + 1;
    return out;
}

// Calls `label` with each; stops where it returns false, and at what is no label.
template <class Label>
void each_of_text(gzFile in, std::int64_t count, const Label& label) {
    std::vector<char> piece(piece_bytes);
    std::int64_t value = 0;
    bool within = false;
    bool negative = false;
    for (int got = 0; (got = ::gzread(in, piece.data(), piece_bytes)) > 0;)
        for (int i = 0; i < got; ++i) {
            const char c = piece[static_cast<std::size_t>(i)];
            constexpr std::int64_t most = std::int64_t{1} << 50;
            if (c >= '0' && c <= '9') {
                value = std::min(10 * value + (c - '0'), most);
                within = true;
                continue;
            }
            if (within && (!label(negative ? -value : value) || --count == 0))
                return;
            value = 0;
            within = false;
            negative = c == '-';
            if (c != '-' && c != ' ' && c != '\n' && c != '\r' && c != '\t')
                return;
        }
}

template <class Number, class Label>
void each_of_binary(gzFile in, std::int64_t count, const Label& label) {
    std::vector<Number> piece(piece_bytes / sizeof(Number));
    for (int got = 0; count > 0 && (got = ::gzread(in, piece.data(), piece_bytes)) > 0;) {
        const auto numbers = static_cast<std::size_t>(got) / sizeof(Number);
        for (std::size_t i = 0; i < numbers && count > 0; ++i, --count)
            if (!label(static_cast<std::int64_t>(piece[i])))
                return;
    }
}

} // namespace

core::Result<void> check_foam_cells(const fs::path& mesh, const std::string& name) {
    constexpr std::array<std::pair<const char*, std::uint64_t>, 4> lists{
        {{"points", 3 * sizeof(float)}, {"faces", 4}, {"owner", 4}, {"neighbour", 4}}};
    for (const auto& [list, bytes] : lists) {
        const auto file = foam_file(mesh / list);
        const File in(file ? ::gzopen(file->c_str(), "rb") : nullptr, ::gzclose);
        const auto head = in ? head_of(in.get()) : std::nullopt;
        if (!head)
            continue; // told by VTK
        const auto count = static_cast<std::uint64_t>(std::max<std::int64_t>(head->count, 0));
        if (auto fits = check_claim(name + "/" + list, count, bytes); !fits)
            return fits;
    }
    std::int64_t faces = 0;
    for (const char* list : {"owner", "neighbour"}) {
        const auto file = foam_file(mesh / list);
        const File in(file ? ::gzopen(file->c_str(), "rb") : nullptr, ::gzclose);
        const auto head = in ? head_of(in.get()) : std::nullopt;
        if (!head || ::gzseek(in.get(), static_cast<z_off_t>(head->begin), SEEK_SET) < 0)
            return {};
        if (faces == 0)
            faces = head->count; // each has an owner
        // A cell has four faces at least, and a face lies between two cells at most.
        const std::int64_t most = faces / 2;
        std::optional<std::int64_t> wrong;
        const auto fits = [&](std::int64_t cell) {
            if (cell >= most ||
                cell < -1) // -1: older versions write it where there is no neighbour
                wrong = cell;
            return !wrong;
        };
        if (!head->binary)
            each_of_text(in.get(), head->count, fits);
        else if (head->label_bytes == 8)
            each_of_binary<std::int64_t>(in.get(), head->count, fits);
        else
            each_of_binary<std::int32_t>(in.get(), head->count, fits);
        if (wrong)
            return core::fail(core::Error::Code::Corrupt,
                              name + "/" + list + " is damaged: it names cell " +
                                  std::to_string(*wrong) + ", and " + std::to_string(faces) +
                                  " faces bound " + std::to_string(most) + " cells at most",
                              "copy the mesh again");
    }
    return {};
}

} // namespace wakesurf::importer
