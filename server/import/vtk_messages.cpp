#include "server/import/vtk_messages.hpp"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace wakesurf::server {

namespace {

class FirstMessage final : public vtkOutputWindow {
  public:
    static FirstMessage* New() {
        auto* made = new FirstMessage; // VTK counts its references
        made->InitializeObjectBase();
        return made;
    }

    void DisplayText(const char* text) override {
        if (first.empty() && text != nullptr)
            first = text;
    }

    void DisplayDebugText(const char*) override {}

    std::string first;
};

// "ERROR: In ./IO/XML/vtkXMLReader.cxx, line 501\nvtkXMLReader (0x55..): Error opening file x\n\n"
std::string sentence(std::string text) {
    if (const auto object = text.find("): "); object != std::string::npos)
        text.erase(0, object + 3);
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
        text.pop_back();
    constexpr std::size_t longest = 200;
    return text.substr(0, longest);
}

} // namespace

VtkMessages::VtkMessages() {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // a second way out besides the window
    vtkOutputWindow::SetInstance(vtkSmartPointer<FirstMessage>::New());
}

VtkMessages::~VtkMessages() {
    vtkOutputWindow::SetInstance(nullptr);
}

core::Result<void> VtkMessages::verdict(const std::string& file) const {
    const auto* window = dynamic_cast<FirstMessage*>(vtkOutputWindow::GetInstance());
    if (window == nullptr || window->first.empty())
        return {};
    return core::fail(
        core::Error::Code::Corrupt,
        file + " is damaged or not what it says it is (VTK: " + sentence(window->first) + ")");
}

} // namespace wakesurf::server
