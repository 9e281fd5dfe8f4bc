#include "server/app/python_program.hpp"

#include "server/app/environment.hpp"
#include "server/app/failure.hpp"
#include "server/base/shipped_files.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace wakesurf::server {

namespace {

/// Files in the current folder must not replace modules, as they would for `python -m`.
constexpr const char* beginning = R"python(
import importlib, sys
sys.path[0] = sys.argv.pop(1)
try:
    import numpy
except ImportError:
    sys.exit("wakesurf: this needs numpy (Debian: python3-numpy; another Python that has it: $WAKESURF_PYTHON)")
sys.exit(importlib.import_module("wakesurf." + sys.argv.pop(1)).main())
)python";

/// Prefers the system's Python, which has the packages installed with this program, to the first one in PATH.
std::string python() {
    constexpr const char* of_the_system = "/usr/bin/python3";
    return from_environment("WAKESURF_PYTHON",
                            ::access(of_the_system, X_OK) == 0 ? of_the_system : "python3");
}

} // namespace

int become_python(const std::string& module, const std::vector<std::string>& arguments) {
    const auto client = python_client();
    if (!client)
        return report_failure(client.error());
    ::setenv("WAKESURF", this_program().c_str(), 0);
    std::vector<std::string> words{python(), "-c", beginning, client->string(), module};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execvp(pointers.front(), pointers.data());
    return report_failure(
        {core::Error::Code::Io,
         "cannot start " + words.front() + ": " + std::generic_category().message(errno),
         "it needs Python 3.9 or newer with numpy: Debian, python3-numpy; else name one in "
         "$WAKESURF_PYTHON"});
}

} // namespace wakesurf::server
