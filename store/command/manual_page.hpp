// A program's manual page, made from the same declarations as its --help. Packages install what `wakesurf
// --man-page` prints.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace wakesurf::command {

/// Holds what a page has besides the options; `chapters` is roff: files, environment, examples.
struct ManualPage {
    std::string_view version;
    std::string_view chapters;
};

/// Returns the page in roff (man(7)): every command with its arguments and options.
std::string manual_page(const CLI::App& program, const ManualPage& page);

/// Returns roff that shows `text` literally: dashes stay dashes, and no line is a request.
std::string roff_of(std::string_view text);

} // namespace wakesurf::command
