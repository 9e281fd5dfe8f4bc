#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/plot3d/plot3d_files.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

using core::Error;

namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const auto done = ::write(file, text.data(), text.size());
        if (done <= 0)
            return false;
        text.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
}

// Calls visit(text) with pieces of the file that begin and end between words, each with usual numbers. Stops
// if it returns false.
template <class Visit>
bool visit_usual(const std::string& path, const Visit& visit) {
    std::ifstream in(path, std::ios::binary);
    std::vector<char> chunk(1 << 16);
    std::string out;
    std::string word;
    bool changed = false;
    const auto end_word = [&] {
        const std::string usual = usual_number(word);
        changed = changed || usual != word;
        out += usual;
        word.clear();
    };
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0) {
        for (std::streamsize i = 0; i < in.gcount(); ++i) {
            const char c = chunk[static_cast<std::size_t>(i)];
            const bool between = std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',';
            if (between)
                end_word();
            (between ? out : word).push_back(c);
        }
        if (!visit(out, changed))
            return false;
        out.clear();
    }
    end_word();
    return visit(out, changed);
}

} // namespace

std::string usual_number(std::string_view word) {
    std::string out(word);
    if (word.size() > 64)
        return out;
    const auto mark = word.find_first_of("dDqQ");
    if (mark != std::string_view::npos && mark > 0 &&
        (is_digit(word[mark - 1]) || word[mark - 1] == '.')) {
        out[mark] = 'E';
        return out;
    }
    const auto sign = word.find_last_of("+-");
    if (sign != std::string_view::npos && sign > 0 && sign + 1 < word.size() &&
        (is_digit(word[sign - 1]) || word[sign - 1] == '.') &&
        std::all_of(word.begin() + static_cast<std::ptrdiff_t>(sign) + 1, word.end(), is_digit))
        out.insert(sign, 1, 'E');
    return out;
}

UsualNumbers::UsualNumbers(std::string path) : path_(std::move(path)) {
    const bool same = visit_usual(path_, [](const std::string&, bool changed) { return !changed; });
    if (same)
        return;
    memory_ = ::memfd_create("numbers", MFD_CLOEXEC);
    if (memory_ >= 0 && visit_usual(path_, [this](const std::string& text, bool) {
            return write_all(memory_, text);
        }))
        path_ = "/proc/self/fd/" + std::to_string(memory_);
}

UsualNumbers::~UsualNumbers() {
    if (memory_ >= 0)
        ::close(memory_);
}

namespace {

constexpr std::int64_t most_blocks = 100'000;
constexpr std::int64_t most_nodes = std::int64_t{1} << 40;

// Holds the numbers at the beginning of a text, and counts all of them.
struct Tokens {
    std::vector<double> first;
    std::int64_t count = 0;
    bool numbers = true;
    bool ended = false; ///< with a blank: the last number is whole
};

Tokens tokens_of(std::ifstream& in, std::size_t wanted) {
    Tokens out;
    std::string token;
    const auto end_token = [&] {
        if (token.empty())
            return;
        ++out.count;
        const auto number = finite_number(usual_number(token));
        out.numbers = out.numbers && number.has_value();
        if (out.first.size() < wanted)
            out.first.push_back(number.value_or(-1.0));
        token.clear();
    };
    std::vector<char> chunk(1 << 16);
    while (out.numbers &&
           (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0)) {
        const auto text = std::span(chunk).first(static_cast<std::size_t>(in.gcount()));
        for (const char c : text) {
            out.ended = std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',';
            if (out.ended)
                end_token();
            else if (token.size() < 64)
                token.push_back(c);
        }
    }
    end_token();
    return out;
}

// Binary files have bytes among their first that no number is written with.
bool is_text(std::ifstream& in) {
    std::array<char, 12> start{};
    in.seekg(0);
    in.read(start.data(), start.size());
    const auto read = std::span(start).first(static_cast<std::size_t>(in.gcount()));
    in.clear();
    in.seekg(0);
    return std::all_of(read.begin(), read.end(), [](char c) {
        return std::isspace(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("0123456789.,+-eE").find(c) != std::string_view::npos;
    });
}

class Bytes {
  public:
    Bytes(std::ifstream& in, bool big_endian) : in_(in), big_(big_endian) {}

    std::optional<std::int64_t> integer() {
        const auto bits = word<std::uint32_t>();
        if (!bits)
            return std::nullopt;
        return static_cast<std::int32_t>(*bits);
    }

    std::optional<double> real(bool doubles) {
        if (doubles) {
            const auto bits = word<std::uint64_t>();
            return bits ? std::optional(std::bit_cast<double>(*bits)) : std::nullopt;
        }
        const auto bits = word<std::uint32_t>();
        return bits ? std::optional<double>(std::bit_cast<float>(*bits)) : std::nullopt;
    }

  private:
    template <class Word>
    std::optional<Word> word() {
        std::array<unsigned char, sizeof(Word)> bytes{};
        in_.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
        if (!in_)
            return std::nullopt;
        Word out = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i)
            out = static_cast<Word>(out << 8 | bytes[big_ ? i : bytes.size() - 1 - i]);
        return out;
    }

    std::ifstream& in_;
    bool big_;
};

std::optional<std::int64_t> nodes_of(const std::array<int, 3>& block) {
    std::int64_t out = 1;
    for (const int n : block) {
        if (n < 1 || out > most_nodes / n)
            return std::nullopt;
        out *= n;
    }
    return out;
}

// Returns the numbers of nodes of each grid; `axes` is 2 for files of planes, whose k is 1.
std::optional<std::vector<std::array<int, 3>>>
read_blocks(std::ifstream& in, const Plot3dLayout& layout, int axes) {
    in.clear();
    in.seekg(0);
    Bytes bytes(in, layout.big_endian);
    const auto record = [&](std::int64_t size) {
        return !layout.records || bytes.integer() == size;
    };
    std::int64_t count = 1;
    if (layout.several) {
        if (!record(4))
            return std::nullopt;
        count = bytes.integer().value_or(0);
        if (count < 1 || count > most_blocks || !record(4))
            return std::nullopt;
    }
    if (!record(4 * axes * count))
        return std::nullopt;
    std::vector<std::array<int, 3>> blocks;
    for (std::int64_t i = 0; i < count; ++i) {
        std::array<int, 3> block{1, 1, 1};
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis)
            block[axis] = static_cast<int>(bytes.integer().value_or(0));
        if (!nodes_of(block))
            return std::nullopt;
        blocks.push_back(block);
    }
    if (!record(4 * axes * count))
        return std::nullopt;
    return blocks;
}

std::int64_t header_bytes(const Plot3dLayout& layout, int axes) {
    const std::int64_t mark = layout.records ? 8 : 0;
    return (layout.several ? 4 + mark : 0) +
           4 * axes * static_cast<std::int64_t>(layout.blocks.size()) + mark;
}

std::int64_t grid_bytes(const Plot3dLayout& layout, int axes) {
    std::int64_t out = header_bytes(layout, axes);
    for (const auto& block : layout.blocks)
        out += *nodes_of(block) * (axes * (layout.doubles ? 8 : 4) + (layout.blanking ? 4 : 0)) +
               (layout.records ? 8 : 0);
    return out;
}

// Counts four numbers, then density, momentum and energy, for each block.
std::int64_t solution_bytes(const Plot3dLayout& layout) {
    std::int64_t out = header_bytes(layout, 3);
    for (const auto& block : layout.blocks)
        out += (4 + 5 * *nodes_of(block)) * (layout.doubles ? 8 : 4) + (layout.records ? 16 : 0);
    return out;
}

std::optional<Plot3dLayout> binary_layout(std::ifstream& in, std::int64_t size, int axes) {
    for (int choice = 0; choice < 32; ++choice) {
        Plot3dLayout layout;
        layout.big_endian = (choice & 1) != 0;
        layout.records = (choice & 2) != 0;
        layout.several = (choice & 4) != 0;
        layout.doubles = (choice & 8) != 0;
        layout.blanking = (choice & 16) != 0;
        auto blocks = read_blocks(in, layout, axes);
        if (!blocks)
            continue;
        layout.blocks = std::move(*blocks);
        if (grid_bytes(layout, axes) == size)
            return layout;
    }
    return std::nullopt;
}

std::optional<Plot3dLayout> text_layout(std::ifstream& in, int axes) {
    in.clear();
    in.seekg(0);
    const auto tokens = tokens_of(in, static_cast<std::size_t>(1 + 3 * most_blocks));
    if (!tokens.numbers || !tokens.ended)
        return std::nullopt;
    for (const bool several : {false, true})
        for (const bool blanking : {false, true}) {
            Plot3dLayout layout;
            layout.ascii = layout.doubles = true;
            layout.several = several;
            layout.blanking = blanking;
            const auto first = [&](std::size_t i) {
                return i < tokens.first.size() && tokens.first[i] >= 1 && tokens.first[i] < 1e9
                           ? static_cast<int>(tokens.first[i])
                           : 0;
            };
            const std::size_t blocks = several ? static_cast<std::size_t>(first(0)) : 1;
            const auto per_block = static_cast<std::size_t>(axes);
            std::int64_t wanted = static_cast<std::int64_t>(several + per_block * blocks);
            bool sound = blocks > 0 && blocks <= static_cast<std::size_t>(most_blocks);
            for (std::size_t b = 0; sound && b < blocks; ++b) {
                std::array<int, 3> block{1, 1, 1};
                for (std::size_t axis = 0; axis < per_block; ++axis)
                    block[axis] = first(several + per_block * b + axis);
                const auto nodes = nodes_of(block);
                sound = nodes.has_value();
                wanted += nodes.value_or(0) * (axes + blanking);
                layout.blocks.push_back(block);
            }
            if (sound && wanted == tokens.count)
                return layout;
        }
    return std::nullopt;
}

core::Result<Plot3dHeader>
check_text_solution(std::ifstream& in, const std::string& name, const Plot3dLayout& grid) {
    const std::size_t header = (grid.several ? 1 : 0) + 3 * grid.blocks.size();
    std::int64_t wanted = static_cast<std::int64_t>(header);
    for (const auto& block : grid.blocks)
        wanted += 4 + 5 * *nodes_of(block);
    in.seekg(0);
    const auto tokens = tokens_of(in, header + 4);
    bool same = tokens.numbers && tokens.ended && tokens.count == wanted;
    for (std::size_t i = 0; same && i < 3 * grid.blocks.size(); ++i)
        same = tokens.first[(grid.several ? 1 : 0) + i] == grid.blocks[i / 3][i % 3];
    if (!same)
        return core::fail(Error::Code::Corrupt,
                          name + " is truncated or not a solution on the grid: it has " +
                              std::to_string(tokens.count) + " of " + std::to_string(wanted) +
                              " numbers");
    Plot3dHeader out{};
    std::copy_n(tokens.first.begin() + static_cast<std::ptrdiff_t>(header), out.size(),
                out.begin());
    return out;
}

} // namespace

core::Result<Plot3dLayout> grid_layout(const ListedFile& grid) {
    std::ifstream in(grid.path, std::ios::binary | std::ios::ate);
    if (!in)
        return core::fail(Error::Code::Io, "cannot open " + grid.name);
    const auto size = static_cast<std::int64_t>(in.tellg());
    const bool text = is_text(in);
    if (const auto layout = text ? text_layout(in, 3) : binary_layout(in, size, 3))
        return *layout;
    if (text ? text_layout(in, 2) : binary_layout(in, size, 2))
        return core::fail(Error::Code::Unsupported,
                          grid.name + " is not three-dimensional: it is a Plot3D grid in the plane",
                          "extrude it by two cells or more first");
    return core::fail(
        Error::Code::Corrupt,
        grid.name + " is truncated or not a Plot3D grid: no layout of the format has its length",
        "known are ascii and binary grids, single or several, with or without "
        "Fortran records and iblank");
}

core::Result<Plot3dHeader> check_solution(const ListedFile& solution, const Plot3dLayout& grid) {
    made_progress();
    std::ifstream in(solution.path, std::ios::binary | std::ios::ate);
    if (!in)
        return core::fail(Error::Code::Io, "cannot open " + solution.name);
    const auto size = static_cast<std::int64_t>(in.tellg());
    if (is_text(in) != grid.ascii)
        return core::fail(Error::Code::Corrupt,
                          solution.name + " and the grid are not both ascii or both binary");
    if (grid.ascii)
        return check_text_solution(in, solution.name, grid);
    if (size != solution_bytes(grid))
        return core::fail(Error::Code::Corrupt,
                          solution.name + " is truncated or not a solution on the grid: it has " +
                              std::to_string(size) + " of " + std::to_string(solution_bytes(grid)) +
                              " bytes");
    if (read_blocks(in, grid, 3) != grid.blocks)
        return core::fail(Error::Code::Corrupt,
                          solution.name + " does not have the same numbers of nodes as the grid");
    Bytes bytes(in, grid.big_endian);
    if (grid.records && bytes.integer() != (grid.doubles ? 32 : 16))
        return core::fail(Error::Code::Corrupt, solution.name + " has a damaged record");
    Plot3dHeader out{};
    for (double& number : out)
        number = bytes.real(grid.doubles).value_or(0.0);
    return out;
}

} // namespace wakesurf::importer
