#include "server/app/opened_page.hpp"

#include "server/app/environment.hpp"
#include "server/base/private_file.hpp"
#include "server/data/child_process.hpp"

#include <fmt/format.h>
#include <pwd.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <sstream>

namespace wakesurf::server {

namespace fs = std::filesystem;
using core::Error;

namespace {

bool by_ssh() {
    return !from_environment("SSH_CONNECTION").empty();
}

/// Says whether there is a display. One that ssh forwards has a machine's name before the colon:
/// `localhost:10.0`. `:0` is the machine's own screen.
bool has_display() {
    if (in_container())
        return false;
    const std::string display = from_environment("DISPLAY");
    if (by_ssh())
        return display.find(':') != std::string::npos && !display.starts_with(':');
    return !display.empty() || !from_environment("WAYLAND_DISPLAY").empty();
}

std::vector<std::string> split_at(const std::string& text, char between) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, between);)
        if (!part.empty())
            parts.push_back(part);
    return parts;
}

bool is_program(const std::string& name) {
    if (name.find('/') != std::string::npos)
        return ::access(name.c_str(), X_OK) == 0;
    for (const std::string& folder : split_at(from_environment("PATH"), ':'))
        if (::access((folder + "/" + name).c_str(), X_OK) == 0)
            return true;
    return false;
}

std::string html_text(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (std::string_view("&<>\"'").find(letter) != std::string_view::npos)
            out += fmt::format("&#{};", static_cast<int>(letter));
        else
            out += letter;
    }
    return out;
}

std::string page_that_leads_to(const std::string& link) {
    const std::string address = html_text(link);
    return "<!doctype html>\n<meta charset=\"utf-8\">\n<title>wakesurf</title>\n"
           "<meta name=\"referrer\" content=\"no-referrer\">\n"
           "<meta http-equiv=\"refresh\" content=\"0; url=" +
           address + "\">\n<p><a href=\"" + address + "\">Open wakesurf</a></p>\n";
}

/// Makes a folder for this user alone. Empty if it cannot be made.
fs::path private_folder() {
    std::error_code ignored;
    const std::string of_login = from_environment("XDG_RUNTIME_DIR");
    const fs::path place = !of_login.empty() && check_private_folder(of_login, "it", false)
                               ? fs::path(of_login)
                               : fs::temp_directory_path(ignored);
    std::string name = (place / "wakesurf-XXXXXX").string();
    return ::mkdtemp(name.data()) == nullptr ? fs::path() : fs::path(name);
}

/// Starts a command by a shell that ends at once and leaves the browser in a session of its own: Ctrl-C is
/// for the server alone.
core::Result<void> start_apart(const std::vector<std::string>& command) {
    std::vector<std::string> words{"-c", "setsid \"$@\" </dev/null >/dev/null 2>&1 &", "sh"};
    words.insert(words.end(), command.begin(), command.end());
    return run_child("/bin/sh", words, 0, [](std::string_view) {}, {}).map([](const auto&) {});
}

std::string user_name() {
    const passwd* const entry = ::getpwuid(::geteuid());
    return entry == nullptr || entry->pw_name == nullptr ? from_environment("USER")
                                                         : std::string(entry->pw_name);
}

} // namespace

std::vector<std::string> browser_command(const std::string& page) {
    if (!has_display())
        return {};
    for (const std::string& each : split_at(from_environment("BROWSER", "xdg-open"), ':')) {
        std::vector<std::string> words = split_at(each, ' ');
        if (words.empty() || !is_program(words.front()))
            continue;
        bool placed = false;
        for (std::string& word : words)
            if (const auto at = word.find("%s"); at != std::string::npos) {
                word.replace(at, 2, page);
                placed = true;
            }
        if (!placed)
            words.push_back(page);
        return words;
    }
    return {};
}

std::optional<std::string> tunnel_command(const std::string& host, std::uint16_t port) {
    if (!by_ssh())
        return std::nullopt;
    const auto way = split_at(from_environment("SSH_CONNECTION"), ' '); // from, its port, to, ours
    const std::string door = way.size() == 4 && way[3] != "22" ? " -p " + way[3] : "";
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0 || name.front() == '\0')
        return std::nullopt;
    const std::string user = user_name();
    return fmt::format("ssh -N -L {0}:{1}:{0}{2} {3}{4}", port,
                       host == "127.0.0.1" ? "localhost" : host, door,
                       user.empty() ? "" : user + "@", name.data());
}

core::Result<OpenedPage> OpenedPage::open(const std::string& link) {
    if (browser_command("").empty())
        return core::fail(Error::Code::NotFound, "there is no browser to open the page in",
                          "open the link");
    OpenedPage out(private_folder());
    if (out.folder_.empty())
        return core::fail(Error::Code::Io, "there is no place for a private file", "open the link");
    const fs::path page = out.folder_ / "open.html";
    return write_private_file(page, page_that_leads_to(link))
        .and_then([&] { return start_apart(browser_command("file://" + page.string())); })
        .map([&] { return std::move(out); });
}

OpenedPage::~OpenedPage() {
    std::error_code ignored;
    if (!folder_.empty())
        fs::remove_all(folder_, ignored);
}

} // namespace wakesurf::server
