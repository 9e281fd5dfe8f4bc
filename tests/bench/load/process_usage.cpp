#include "tests/bench/load/process_usage.hpp"

#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace wakesurf::bench {

ProcessUsage usage_of(pid_t process) {
    const std::string folder = "/proc/" + std::to_string(process);
    std::ifstream memory(folder + "/statm");
    std::ifstream file(folder + "/stat");
    std::size_t total = 0, resident = 0;
    std::string text;
    if (!(memory >> total >> resident) || !std::getline(file, text))
        throw std::runtime_error("the server's process has ended");
    std::istringstream fields(text.substr(text.rfind(')') + 2)); // its name may hold blanks
    for (int field = 3; field < 14; ++field)
        fields >> text;
    double user = 0, system = 0;
    fields >> user >> system;
    return {resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)),
            (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK))};
}

} // namespace wakesurf::bench
