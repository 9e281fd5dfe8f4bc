#include "importer/base/library_messages.hpp"

#include "core/base/plain_text.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <new>
#include <regex>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace wakesurf::importer {

using core::Error;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

// A descriptor that was closed stays closed: output to it is lost, as it would have been.
std::FILE* moved(int descriptor) {
    const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    std::FILE* const stream = copy < 0 ? nullptr : ::fdopen(copy, "w");
    return stream != nullptr ? stream : std::fopen("/dev/null", "we");
}

} // namespace

OwnOutput take_outputs(bool show_libraries) {
    std::fflush(nullptr);
    const OwnOutput own{moved(STDOUT_FILENO), moved(STDERR_FILENO)};
    const bool show = show_libraries || sanitized;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    const int instead = show ? STDERR_FILENO : nowhere;
    if (instead >= 0)
        ::dup2(instead, STDOUT_FILENO);
    if (!show && nowhere >= 0)
        ::dup2(nowhere, STDERR_FILENO);
    if (nowhere > STDERR_FILENO)
        ::close(nowhere);
    return own;
}

namespace {

class FirstMessage final : public vtkOutputWindow {
  public:
    static FirstMessage* New() {
        auto* made = new FirstMessage; // VTK counts its references
        made->InitializeObjectBase();
        return made;
    }

    void DisplayText(const char* text) override {
        const auto is_expected = [text](const std::string& words) {
            return std::string_view(text).find(words) != std::string_view::npos;
        };
        if (first.empty() && text != nullptr &&
            std::none_of(expected.begin(), expected.end(), is_expected))
            first = text;
    }

    void DisplayDebugText(const char*) override {}

    std::vector<std::string> expected;
    std::string first;
};

} // namespace

VtkMessages::VtkMessages(std::vector<std::string> expected) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // a second way out besides the window
    const auto window = vtkSmartPointer<FirstMessage>::New();
    window->expected = std::move(expected);
    vtkOutputWindow::SetInstance(window);
}

VtkMessages::~VtkMessages() {
    vtkOutputWindow::SetInstance(nullptr);
}

core::Result<void> VtkMessages::verdict(const std::string& file) const {
    const auto* window = dynamic_cast<FirstMessage*>(vtkOutputWindow::GetInstance());
    if (window == nullptr || window->first.empty())
        return {};
    if (window->first.find("nable to allocate") != std::string::npos)
        return core::fail(core::Error::Code::OverLimit,
                          "there is not enough memory to read " + file);
    const std::string words = sentence_of_library(window->first);
    return core::fail(core::Error::Code::Corrupt,
                      file + " is damaged, or not the kind of file that it claims to be" +
                          (words.empty() ? "" : " (VTK: " + words + ")"));
}

Error error_of(const std::exception& thrown, const std::string& what) {
    if (dynamic_cast<const std::bad_alloc*>(&thrown) != nullptr)
        return {Error::Code::OverLimit, "there is not enough memory to read " + what, {}};
    if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&thrown))
        return {Error::Code::Io, "cannot read " + what + ": " + file->code().message(), {}};
    // The standard library throws these for an index or size beyond a container: the text names the container
    // only.
    if (dynamic_cast<const std::logic_error*>(&thrown) != nullptr)
        return {Error::Code::Corrupt, what + " contains an impossible size or number",
                "it is probably damaged; copy or write it again"};
    const std::string words = sentence_of_library(thrown.what());
    return {Error::Code::Io, "cannot read " + what + (words.empty() ? "" : " (" + words + ")"),
            "it is probably damaged; copy or write it again"};
}

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

void send_library_messages_to(std::FILE* own) {
    owners_stream = own;
}

std::string sentence_of_library(std::string text) {
    // VTK says "Algorithm vtkXMLImageDataReader(0x..) returned failure for request: vtkInformation (0x..)
    // ...".
    if (text.find("returned failure for request") != std::string::npos)
        return {};
    constexpr std::size_t longest_input = 2000; // std::regex recurses over what it matches
    text = without_folders(without_place_in_source(text.substr(0, longest_input)), {});
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    constexpr std::string_view trimmed = " .\n";
    text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    constexpr std::size_t longest = 200;
    text = text.substr(0, longest);
    text.erase(text.find_last_not_of(trimmed) + 1); // npos + 1 == 0
    if (owners_stream == nullptr)
        return text;
    std::fprintf(owners_stream, "%s%s\n", library_message_prefix.data(),
                 core::printable_line(text).c_str());
    std::fflush(owners_stream);
    return {};
}

} // namespace wakesurf::importer
