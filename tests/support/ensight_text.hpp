// EnSight Gold files written by hand, in every encoding of the format, so that every fault can be put into
// them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace wakesurf::tests {

enum class EnsightEncoding { Text, Binary, SwappedBinary, Fortran };

class EnsightText {
  public:
    explicit EnsightText(EnsightEncoding encoding) : encoding_(encoding) {}

    void line(std::string text) {
        if (encoding_ == EnsightEncoding::Text) {
            out_ += text + "\n";
            return;
        }
        text.resize(80, ' ');
        record(text);
    }

    void integers(const std::vector<std::int32_t>& values, std::size_t on_a_line = 100) {
        if (encoding_ != EnsightEncoding::Text)
            return record(bytes_of(values));
        char word[32];
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::snprintf(word, sizeof word, "%10d", values[i]);
            out_ += word;
            if ((i + 1) % on_a_line == 0 || i + 1 == values.size())
                out_ += "\n";
        }
    }

    void numbers(const std::vector<float>& values) {
        if (encoding_ != EnsightEncoding::Text)
            return record(bytes_of(values));
        char word[32];
        for (const float value : values) {
            std::snprintf(word, sizeof word, "%12.5e\n", static_cast<double>(value));
            out_ += word;
        }
    }

    const std::string& text() const { return out_; }

  private:
    template <class T>
    std::string bytes_of(const std::vector<T>& values) const {
        std::string out(reinterpret_cast<const char*>(values.data()), 4 * values.size());
        if (encoding_ == EnsightEncoding::SwappedBinary)
            for (std::size_t i = 0; i < out.size(); i += 4)
                std::reverse(out.begin() + static_cast<std::ptrdiff_t>(i),
                             out.begin() + static_cast<std::ptrdiff_t>(i + 4));
        return out;
    }

    void record(const std::string& bytes) {
        const auto length = static_cast<std::uint32_t>(bytes.size());
        const std::string mark(reinterpret_cast<const char*>(&length),
                               encoding_ == EnsightEncoding::Fortran ? 4 : 0);
        out_ += mark + bytes + mark;
    }

    EnsightEncoding encoding_;
    std::string out_;
};

} // namespace wakesurf::tests
