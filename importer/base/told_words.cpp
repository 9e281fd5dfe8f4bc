#include "importer/base/told_words.hpp"

#include "core/base/plain_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <string_view>

namespace wakesurf::importer {

namespace {

constexpr std::string_view around_paths = " \t\n'\"`()[]{}<>,;=|";

std::FILE* owners_stream = nullptr;

bool separates(char c) {
    return around_paths.find(c) != std::string_view::npos;
}

void erase_all(std::string& text, const std::string& part) {
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.erase(at, part.size());
}

// A path begins at a slash behind a separator, and ends before the next separator.
void shorten_absolute_paths(std::string& text) {
    for (std::size_t at = text.find('/'); at != std::string::npos; at = text.find('/', at + 1)) {
        const bool begins = at == 0 || separates(text[at - 1]) || text[at - 1] == ':';
        if (!begins)
            continue;
        std::size_t end = at;
        while (end < text.size() && !separates(text[end]))
            ++end;
        std::size_t name_end = end;
        while (name_end > at + 1 && text[name_end - 1] == '/')
            --name_end;
        const std::size_t last = text.rfind('/', name_end - 1);
        if (end > at + 1)
            text.erase(at, last + 1 - at);
    }
}

// Turns "ERROR: In ./IO/XML/vtkXMLReader.cxx, line 501
// vtkXMLReader (0x55..): Error opening file x
//
// " into the last sentence.
std::string without_place_in_source(const std::string& text) {
    static const std::regex place(
        R"(^\s*(ERROR|Warning|Generic Warning|Error)?:?\s*In [^\n]*, line \d+\s*)");
    static const std::regex object(R"(\b\w+ ?\((0x[0-9a-fA-F]+|\(nil\))\):? ?)");
    return std::regex_replace(std::regex_replace(text, place, ""), object, "");
}

} // namespace

std::string without_folders(std::string text, const std::vector<std::filesystem::path>& folders) {
    std::vector<std::string> known;
    for (const auto& folder : folders)
        if (folder.has_filename() && folder != ".")
            known.push_back(folder.string() + "/");
    std::sort(known.begin(), known.end(),
              [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const auto& folder : known)
        erase_all(text, folder);
    shorten_absolute_paths(text);
    return text;
}

void tell_library_words_to(std::FILE* own) {
    owners_stream = own;
}

std::string sentence_of_library(std::string text) {
    // VTK says "Algorithm vtkXMLImageDataReader(0x..) returned failure for request: vtkInformation (0x..)
    // ...".
    if (text.find("returned failure for request") != std::string::npos)
        return {};
    constexpr std::size_t looked_at = 2000; // std::regex recurses over what it matches
    text = without_folders(without_place_in_source(text.substr(0, looked_at)), {});
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    constexpr std::string_view trimmed = " .\n";
    text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    constexpr std::size_t longest = 200;
    text = text.substr(0, longest);
    text.erase(text.find_last_not_of(trimmed) + 1); // npos + 1 == 0
    if (owners_stream == nullptr)
        return text;
    std::fprintf(owners_stream, "%s%s\n", library_words_prefix.data(),
                 core::printable_line(text).c_str());
    std::fflush(owners_stream);
    return {};
}

} // namespace wakesurf::importer
