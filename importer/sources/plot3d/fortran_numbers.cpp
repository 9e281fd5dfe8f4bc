#include "importer/sources/plot3d/fortran_numbers.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <vector>

namespace wakesurf::importer {

namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const auto done = ::write(file, text.data(), text.size());
        if (done <= 0)
            return false;
        text.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
}

// Calls visit(text) with pieces of the file that begin and end between words, each with usual numbers. Stops
// if it returns false.
template <class Visit>
bool visit_usual(const std::string& path, const Visit& visit) {
    std::ifstream in(path, std::ios::binary);
    std::vector<char> chunk(1 << 16);
    std::string out;
    std::string word;
    bool changed = false;
    const auto end_word = [&] {
        const std::string usual = usual_number(word);
        changed = changed || usual != word;
        out += usual;
        word.clear();
    };
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0) {
        for (std::streamsize i = 0; i < in.gcount(); ++i) {
            const char c = chunk[static_cast<std::size_t>(i)];
            const bool between = std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',';
            if (between)
                end_word();
            (between ? out : word).push_back(c);
        }
        if (!visit(out, changed))
            return false;
        out.clear();
    }
    end_word();
    return visit(out, changed);
}

} // namespace

std::string usual_number(std::string_view word) {
    std::string out(word);
    if (word.size() > 64)
        return out;
    const auto mark = word.find_first_of("dDqQ");
    if (mark != std::string_view::npos && mark > 0 &&
        (is_digit(word[mark - 1]) || word[mark - 1] == '.')) {
        out[mark] = 'E';
        return out;
    }
    const auto sign = word.find_last_of("+-");
    if (sign != std::string_view::npos && sign > 0 && sign + 1 < word.size() &&
        (is_digit(word[sign - 1]) || word[sign - 1] == '.') &&
        std::all_of(word.begin() + static_cast<std::ptrdiff_t>(sign) + 1, word.end(), is_digit))
        out.insert(sign, 1, 'E');
    return out;
}

UsualNumbers::UsualNumbers(std::string path) : path_(std::move(path)) {
    const bool same = visit_usual(path_, [](const std::string&, bool changed) { return !changed; });
    if (same)
        return;
    memory_ = ::memfd_create("numbers", MFD_CLOEXEC);
    if (memory_ >= 0 && visit_usual(path_, [this](const std::string& text, bool) {
            return write_all(memory_, text);
        }))
        path_ = "/proc/self/fd/" + std::to_string(memory_);
}

UsualNumbers::~UsualNumbers() {
    if (memory_ >= 0)
        ::close(memory_);
}

} // namespace wakesurf::importer
