#include "import/readers/vtk_errors.hpp"

#include "ciel/types.hpp"

#include <mutex>
#include <new>
#include <regex>
#include <utility>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace server::importer {

namespace {

std::mutex reported_mutex;
std::string reported; // the first error; later errors are consequences of the first error

// Converts "ERROR: In FILE, line N\nvtkSomeReader (0x...): message\n\n" to "message (vtkSomeReader)".
std::string sentence(const std::string& text) {
    static const std::regex form(R"(ERROR: In [^\n]*\n(\w+) \([^)]*\): ([^\n]*)[\s\S]*)");
    std::smatch match;
    if (!std::regex_match(text, match, form)) return text.substr(0, text.find('\n'));
    return match[2].str() + " (" + match[1].str() + ")";
}

class CapturingWindow : public vtkOutputWindow {
public:
    static CapturingWindow* New();
    vtkTypeMacro(CapturingWindow, vtkOutputWindow)

        void DisplayText(const char*) override {}
    void DisplayWarningText(const char*) override {}
    void DisplayGenericWarningText(const char*) override {}
    void DisplayDebugText(const char*) override {}
    void DisplayErrorText(const char* text) override {
        const std::scoped_lock lock(reported_mutex);
        if (reported.empty()) reported = sentence(text);
    }
};
vtkStandardNewMacro(CapturingWindow)

} // namespace

void capture_vtk_errors() {
    const auto window = vtkSmartPointer<CapturingWindow>::New();
    vtkOutputWindow::SetInstance(window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void throw_vtk_errors(const std::string& file) {
    const std::scoped_lock lock(reported_mutex);
    if (reported.empty()) return;
    const std::string text = std::exchange(reported, {});
    if (text.find("nable to allocate") != std::string::npos) throw std::bad_alloc();
    throw ciel::Error(file + ": cannot be read: " + text);
}

void forget_vtk_errors() {
    const std::scoped_lock lock(reported_mutex);
    reported.clear();
}

} // namespace server::importer
