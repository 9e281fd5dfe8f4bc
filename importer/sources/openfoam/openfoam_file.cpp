#include "importer/sources/openfoam/openfoam_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

// Splits a text into words, and ( ) { } ; as tokens of their own, without comments and quotes.
std::vector<std::string_view> tokens_of(std::string_view text) {
    std::vector<std::string_view> out;
    const auto ends_word = [](char c) {
        return std::isspace(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("(){};\"").find(c) != std::string_view::npos;
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            const auto end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 2;
        } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0 || text[i] == '"') {
            ++i;
        } else {
            auto end = i + 1;
            if (!ends_word(text[i]))
                while (end < text.size() && !ends_word(text[end]))
                    ++end;
            out.push_back(text.substr(i, end - i));
            i = end;
        }
    }
    return out;
}

bool has_letter(std::string_view text) {
    return std::any_of(text.begin(), text.end(),
                       [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

// Adds the powers of units such as "s^-1". Returns false if one is not known.
bool add_powers(const std::vector<std::string_view>& tokens,
                const std::array<const char*, 7>& names,
                std::array<double, 7>& powers) {
    for (const auto token : tokens) {
        const auto hat = std::min(token.find('^'), token.size());
        const auto name = token.substr(0, hat);
        double power = 1.0;
        const char* const end = token.data() + token.size();
        if (hat < token.size() && std::from_chars(token.data() + hat + 1, end, power).ptr != end)
            return false;
        const auto known = std::find(names.begin(), names.end(), name);
        if (known == names.end() && name != "Pa")
            return false;
        if (known != names.end())
            powers[static_cast<std::size_t>(known - names.begin())] += power;
        for (std::size_t i = 0; name == "Pa" && i < 3; ++i)
            powers[i] += power * (i == 0 ? 1.0 : i == 1 ? -1.0 : -2.0);
    }
    return true;
}

// Returns the position just behind the FoamFile { ... } of a file, or its start.
std::size_t behind_header(std::string_view text) {
    const auto start = text.find("FoamFile");
    const auto end = start == std::string_view::npos ? start : text.find('}', start);
    return end == std::string_view::npos ? 0 : end + 1;
}

} // namespace

std::optional<fs::path> foam_file(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored))
        return file;
    fs::path packed = file;
    packed += ".gz";
    if (fs::is_regular_file(packed, ignored))
        return packed;
    return std::nullopt;
}

std::optional<std::string> foam_content(const fs::path& file, std::size_t at_most) {
    // zlib passes plain files through.
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(::gzopen(file.c_str(), "rb"), ::gzclose);
    if (!in)
        return std::nullopt;
    std::string out;
    std::array<char, 1 << 16> part{};
    while (out.size() < at_most) {
        const auto wanted = std::min(part.size(), at_most - out.size());
        const int got = ::gzread(in.get(), part.data(), static_cast<unsigned>(wanted));
        if (got < 0)
            return std::nullopt;
        if (got == 0)
            break;
        out.append(part.data(), static_cast<std::size_t>(got));
    }
    return out;
}

std::vector<std::string> foam_words(const fs::path& file) {
    const auto found = foam_file(file);
    const auto text = found ? foam_content(*found, std::size_t{1} << 20) : std::nullopt;
    if (!text)
        return {};
    const auto words = tokens_of(std::string_view(*text).substr(behind_header(*text)));
    return {words.begin(), words.end()};
}

std::optional<FoamHeader> read_foam_header(const fs::path& file) {
    const auto text = foam_content(file, foam_header_bytes);
    if (!text)
        return std::nullopt;
    const auto body = behind_header(*text);
    const auto tokens = tokens_of(std::string_view(*text).substr(0, body));
    if (tokens.empty() || tokens.front() != "FoamFile")
        return std::nullopt;
    FoamHeader out;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (tokens[i] == "class")
            out.type = tokens[i + 1];
        if (tokens[i] == "object")
            out.object = tokens[i + 1];
    }
    const std::string_view rest = std::string_view(*text).substr(body);
    if (const auto at = rest.find("dimensions"); at != std::string_view::npos) {
        const auto open =
            rest.find_first_not_of(" \t\r\n", at + std::string_view("dimensions").size());
        const auto close = rest.find(']', at);
        if (open != std::string_view::npos && close != std::string_view::npos && open < close)
            out.unit = foam_unit(rest.substr(open, close + 1 - open));
    }
    if (const auto list = rest.find("List<", std::min(rest.find("internalField"), rest.size()));
        list != std::string_view::npos) {
        const auto number =
            rest.find_first_of("0123456789", std::min(rest.find('>', list), rest.size()));
        if (number != std::string_view::npos)
            std::from_chars(rest.data() + number, rest.data() + rest.size(), out.values);
    }
    return out;
}

core::Result<std::vector<FoamPatch>> read_foam_patches(const fs::path& file,
                                                       const std::string& name) {
    const auto text = foam_content(file, std::numeric_limits<std::size_t>::max());
    if (!text)
        return core::fail(Error::Code::Io, name + " cannot be read");
    const auto tokens = tokens_of(std::string_view(*text).substr(behind_header(*text)));
    const auto damaged = core::fail(Error::Code::Corrupt, name + " is not a list of patches");
    const auto begin = std::find(tokens.begin(), tokens.end(), "(");
    if (begin == tokens.end() || tokens.back() != ")")
        return damaged;
    std::vector<FoamPatch> out;
    int depth = 0;
    for (auto at = begin + 1; at != tokens.end(); ++at) {
        if (*at == "{" && ++depth == 1)
            out.push_back({std::string(*(at - 1)), {}, 0, {}, {}, {}});
        if (*at == "}")
            --depth;
        if (depth == 1 && at + 1 != tokens.end()) {
            if (*at == "type")
                out.back().type = *(at + 1);
            if (*at == "neighbourPatch")
                out.back().neighbour = *(at + 1);
            if (*at == "referPatch")
                out.back().part_of = *(at + 1);
        }
        if (*at == "inGroups" && depth == 1)
            for (auto group = std::find(at, tokens.end(), "(");
                 group != tokens.end() && *group != ")"; ++group)
                if (*group != "(")
                    out.back().groups.emplace_back(*group);
        if (*at == "nFaces" && depth == 1 && at + 1 != tokens.end()) {
            const auto number = *(at + 1);
            const char* const end = number.data() + number.size();
            if (std::from_chars(number.data(), end, out.back().faces).ptr != end)
                return damaged;
        }
    }
    if (depth != 0)
        return damaged;
    return out;
}

bool written_by_hand(const fs::path& file) {
    constexpr std::size_t at_most = 1 << 16;
    const auto text = foam_content(file, at_most);
    if (!text)
        return false;
    const auto tokens = tokens_of(std::string_view(*text).substr(behind_header(*text)));
    const bool directive = std::any_of(tokens.begin(), tokens.end(), [](std::string_view token) {
        return token.size() > 1 && token[0] == '#' &&
               std::isalpha(static_cast<unsigned char>(token[1])) != 0;
    });
    const auto inside = std::find(tokens.begin(), tokens.end(), "internalField");
    return directive ||
           (inside != tokens.end() && inside + 1 != tokens.end() && *(inside + 1) == "uniform");
}

namespace {

// Calls `directive` with each word that begins with #, outside of comments and quotes, until it returns true, and
// returns that; and false once `ends` is true for a character.
template <class Directive, class Ends>
bool any_directive(const fs::path& file, const Directive& directive, const Ends& ends) {
    constexpr std::string_view ends_a_word = " \t\r\n(){};\"";
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(::gzopen(file.c_str(), "rb"), ::gzclose);
    std::array<char, 1 << 16> part{};
    enum class Within { Text, Quote, Line, Block } within = Within::Text;
    char before = ' ';
    std::string word; // a # that begins one, and the letters behind it
    for (int got = 0;
         in && (got = ::gzread(in.get(), part.data(), static_cast<unsigned>(part.size()))) > 0;)
        for (const char c : std::string_view(part.data(), static_cast<std::size_t>(got))) {
            const bool closes = (within == Within::Quote && c == '"') ||
                                (within == Within::Line && c == '\n') ||
                                (within == Within::Block && before == '*' && c == '/');
            if (closes) {
                within = Within::Text;
                before = ' ';
                continue;
            }
            if (within == Within::Text) {
                const bool goes_on =
                    !word.empty() && std::isalpha(static_cast<unsigned char>(c)) != 0;
                if (goes_on)
                    word += c;
                else if (word.size() > 1 && directive(word))
                    return true;
                if (ends(c))
                    return false;
                if (!goes_on)
                    word =
                        c == '#' && ends_a_word.find(before) != std::string_view::npos ? "#" : "";
                if (c == '"')
                    within = Within::Quote;
                if (before == '/' && (c == '/' || c == '*'))
                    within = c == '/' ? Within::Line : Within::Block;
            }
            before = c;
        }
    return false;
}

} // namespace

bool has_directive(const fs::path& file) {
    const auto start = foam_content(file, foam_header_bytes);
    const bool binary =
        start && start->substr(0, behind_header(*start)).find("binary") != std::string::npos;
    return any_directive(
        file, [](const std::string&) { return true; },
        [binary](char c) { return binary && c == '('; });
}

bool has_include_in_header(const fs::path& file) {
    return any_directive(
        file, [](const std::string& word) { return word.find("include") != std::string::npos; },
        [](char c) { return c == '}'; });
}

bool ends_as_written(const fs::path& file) {
    constexpr std::streamoff at_most = 4096; // of blank lines
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in)
        return true;
    const std::streamoff size = in.tellg();
    in.seekg(std::max<std::streamoff>(0, size - at_most));
    const std::string end{std::istreambuf_iterator<char>(in), {}};
    const auto last = end.find_last_not_of(" \t\r\n");
    return last != std::string::npos && (end[last] == '}' || end[last] == '/');
}

bool same_foam_body(const fs::path& one, const fs::path& other) {
    constexpr auto all = std::numeric_limits<std::size_t>::max();
    const auto first = foam_content(one, all);
    const auto second = foam_content(other, all);
    return first && second &&
           std::string_view(*first).substr(behind_header(*first)) ==
               std::string_view(*second).substr(behind_header(*second));
}

std::string foam_unit(std::string_view dimensions) {
    constexpr std::array<const char*, 7> names{"kg", "m", "s", "K", "mol", "A", "cd"};
    std::array<double, 7> powers{};
    if (dimensions.size() < 2 || dimensions.front() != '[' || dimensions.back() != ']')
        return {};
    const auto tokens = tokens_of(dimensions.substr(1, dimensions.size() - 2));
    if (has_letter(dimensions)) {
        if (!add_powers(tokens, names, powers))
            return {};
    } else if (tokens.size() != 5 && tokens.size() != 7) {
        return {};
    }
    for (std::size_t i = 0; !has_letter(dimensions) && i < tokens.size(); ++i) {
        const char* const end = tokens[i].data() + tokens[i].size();
        if (std::from_chars(tokens[i].data(), end, powers[i]).ptr != end)
            return {};
    }
    if (powers == std::array<double, 7>{1, -1, -2, 0, 0, 0, 0})
        return "Pa";
    std::string over;
    std::string under;
    int divisors = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (powers[i] == 0.0)
            continue;
        std::string& side = powers[i] > 0 ? over : under;
        divisors += powers[i] < 0 ? 1 : 0;
        const double power = std::abs(powers[i]);
        side += side.empty() ? "" : " ";
        side += names[i];
        if (power != 1.0) {
            std::array<char, 32> text{};
            const auto end = std::to_chars(text.data(), text.data() + text.size(), power).ptr;
            side.append(text.data(), end);
        }
    }
    if (under.empty())
        return over;
    return (over.empty() ? "1" : over) + "/" + (divisors > 1 ? "(" + under + ")" : under);
}

} // namespace wakesurf::importer
