#include "core/base/disk.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/sources/ensight/ensight_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <new>
#include <span>

namespace wakesurf::importer {

using core::Error;

namespace {

constexpr std::size_t line_bytes = 80;

bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

std::string trimmed(std::string_view text) {
    text = text.substr(0, std::min(text.find('\0'), text.size()));
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    return std::string(text);
}

std::uint32_t turned(std::uint32_t v) {
    return v >> 24 | (v >> 8 & 0xff00u) | (v << 8 & 0xff0000u) | v << 24;
}

} // namespace

core::Result<EnsightStream> EnsightStream::open(const NamedFile& file) {
    EnsightStream out;
    out.name_ = file.name;
    const core::PosixDisk disk;
    const auto size = disk.size(file.path);
    if (!size && size.error().code == Error::Code::NotFound)
        return core::fail(Error::Code::NotFound, file.name + " is not there");
    if (!size)
        return tl::unexpected(size.error());
    if (auto fits = check_claim(file.name, *size, 1); !fits)
        return tl::unexpected(fits.error());
    const auto read_all = [&] {
        out.text_.resize(*size);
        return disk.read(file.path, 0, std::as_writable_bytes(std::span(out.text_)));
    };
    if (auto read = within_memory(file.name, read_all); !read)
        return tl::unexpected(read.error());
    return out;
}

EnsightStream::Encoding EnsightStream::detect() {
    constexpr std::size_t record_mark = 4;
    const std::string_view text = text_;
    if (text.starts_with("C Binary")) {
        encoding_ = Encoding::CBinary;
        at_ = std::min(line_bytes, text.size());
    } else if (text.size() > record_mark &&
               text.substr(record_mark).starts_with("Fortran Binary")) {
        encoding_ = Encoding::FortranBinary;
        std::uint32_t mark = 0;
        std::memcpy(&mark, text.data(), sizeof mark);
        swapped_ = mark != line_bytes;
        order_known_ = true;
        at_ = std::min(line_bytes + 2 * record_mark, text.size());
    }
    return encoding_;
}

tl::unexpected<Error> EnsightStream::damaged(const std::string& what) const {
    return core::fail(Error::Code::Corrupt, name_ + " is damaged or incomplete: " + what);
}

bool EnsightStream::at_end() {
    if (encoding_ == Encoding::Text)
        while (at_ < text_.size() && is_space(text_[at_]))
            ++at_;
    return at_ >= text_.size();
}

core::Result<std::string_view> EnsightStream::bytes(std::size_t count) {
    const std::size_t mark = encoding_ == Encoding::FortranBinary ? 4 : 0;
    if (count > text_.size() || text_.size() - at_ < count + 2 * mark)
        return damaged("it ends too early");
    for (const std::size_t place : {at_, at_ + mark + count}) {
        std::uint32_t length = 0;
        std::memcpy(&length, text_.data() + place, mark);
        if (mark > 0 && (swapped_ ? turned(length) : length) != count)
            return damaged("a record has the wrong length");
    }
    const auto out = std::string_view(text_).substr(at_ + mark, count);
    at_ += count + 2 * mark;
    return out;
}

core::Result<std::string> EnsightStream::line() {
    before_line_ = at_;
    if (encoding_ != Encoding::Text)
        return bytes(line_bytes).map(trimmed);
    const auto end = text_.find('\n', at_);
    if (end == std::string::npos)
        return damaged("it ends too early");
    const auto out = trimmed(std::string_view(text_).substr(at_, end - at_));
    at_ = end + 1;
    return out;
}

// A word that the end of the file cuts off may be half a number.
core::Result<std::string_view> EnsightStream::word() {
    if (at_end())
        return damaged("it ends too early");
    auto end = at_;
    while (end < text_.size() && !is_space(text_[end]))
        ++end;
    if (end == text_.size())
        return damaged("it ends too early");
    const auto out = std::string_view(text_).substr(at_, end - at_);
    at_ = end;
    return out;
}

template <class T>
core::Result<std::vector<T>> EnsightStream::values(std::size_t count) {
    static_assert(sizeof(T) == sizeof(std::uint32_t));
    // A number takes at least two bytes of text: this bounds the memory by the size of the file.
    if (count > text_.size() / (encoding_ == Encoding::Text ? 2 : sizeof(T)))
        return damaged("it ends too early");
    std::vector<T> out(count);
    if (encoding_ != Encoding::Text) {
        const auto found = bytes(count * sizeof(T));
        if (!found)
            return tl::unexpected(found.error());
        if (count > 0)
            std::memcpy(out.data(), found->data(), found->size());
        if (swapped_)
            for (T& value : out)
                value = std::bit_cast<T>(turned(std::bit_cast<std::uint32_t>(value)));
        return out;
    }
    for (T& value : out) {
        auto found = word();
        if (!found)
            return tl::unexpected(found.error());
        if (found->starts_with('+'))
            found->remove_prefix(1);
        const auto [end, error] =
            std::from_chars(found->data(), found->data() + found->size(), value);
        // Numbers too small for a float are written by programs that compute in doubles.
        if (error == std::errc::result_out_of_range &&
            found->find("e-") == std::string_view::npos &&
            found->find("E-") == std::string_view::npos)
            return damaged("'" + std::string(*found) + "' is out of range");
        if (end != found->data() + found->size())
            return damaged("'" + std::string(*found) + "' is not a number");
        if (error == std::errc::result_out_of_range)
            value = T{};
    }
    const auto end = text_.find('\n', at_);
    if (end != std::string::npos &&
        std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                    text_.begin() + static_cast<std::ptrdiff_t>(end), is_space))
        at_ = end + 1;
    return out;
}

core::Result<std::vector<std::int32_t>> EnsightStream::integers(std::size_t count) {
    return values<std::int32_t>(count);
}

core::Result<std::vector<float>> EnsightStream::numbers(std::size_t count) {
    return values<float>(count);
}

core::Result<std::size_t> EnsightStream::count() {
    auto found = integers(1);
    if (!found)
        return tl::unexpected(found.error());
    auto value = found->front();
    // The first one is a part's number, which the format limits.
    if (constexpr std::uint32_t highest_part = 65536;
        encoding_ == Encoding::CBinary && !order_known_) {
        if (static_cast<std::uint32_t>(value) > highest_part) {
            swapped_ = !swapped_;
            value = static_cast<std::int32_t>(turned(static_cast<std::uint32_t>(value)));
        }
        order_known_ = true;
    }
    if (value < 0)
        return damaged("it counts " + std::to_string(value));
    return static_cast<std::size_t>(value);
}

} // namespace wakesurf::importer
