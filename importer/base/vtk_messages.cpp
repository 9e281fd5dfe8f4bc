#include "importer/base/vtk_messages.hpp"

#include "importer/base/told_words.hpp"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace wakesurf::importer {

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

} // namespace wakesurf::importer
