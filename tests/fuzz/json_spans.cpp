#include "tests/fuzz/json_spans.hpp"

namespace wakesurf::fuzz {

namespace {

using Kind = JsonSpan::Kind;

constexpr std::size_t deepest = 100;

class Scan {
  public:
    Scan(std::string_view text, std::size_t from) : text_(text), at_(from) {}

    bool value(std::size_t parent, std::size_t key, std::size_t depth) {
        skip_blanks();
        const std::size_t own = spans.size();
        spans.push_back({Kind::Word, at_, at_, parent, key == text_.npos ? at_ : key, 0});
        const char first = next();
        if (first == '{' || first == '[') {
            spans[own].kind = first == '{' ? Kind::Object : Kind::Array;
            if (depth == deepest || !inner(own, depth))
                return false;
        } else if (first == '"') {
            spans[own].kind = Kind::Text;
            if (!text())
                return false;
        } else {
            const bool number = first == '-' || (first >= '0' && first <= '9');
            spans[own].kind = number ? Kind::Number : Kind::Word;
            at_ = text_.find_first_not_of(number ? "+-.0123456789Ee" : "aeflnrstu", at_);
            at_ = at_ == text_.npos ? text_.size() : at_;
        }
        spans[own].end = at_;
        return spans[own].end > spans[own].begin;
    }

    std::vector<JsonSpan> spans;

  private:
    char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skip_blanks() {
        while (next() == ' ' || next() == '\t' || next() == '\n' || next() == '\r')
            ++at_;
    }

    bool take(char wanted) {
        skip_blanks();
        const bool there = next() == wanted;
        at_ += there ? 1 : 0;
        return there;
    }

    bool text() {
        for (++at_; at_ < text_.size(); ++at_)
            if (text_[at_] == '\\')
                ++at_;
            else if (text_[at_] == '"')
                return ++at_, true;
        return false;
    }

    bool inner(std::size_t own, std::size_t depth) {
        const bool object = spans[own].kind == Kind::Object;
        const char close = object ? '}' : ']';
        ++at_;
        for (skip_blanks(); next() != close; ++spans[own].inner) {
            if (spans[own].inner > 0 && !take(','))
                return false;
            skip_blanks();
            std::size_t key = text_.npos;
            if (object) {
                key = at_;
                if (next() != '"' || !text() || !take(':'))
                    return false;
            }
            if (!value(own, key, depth + 1))
                return false;
            skip_blanks();
        }
        ++at_;
        return true;
    }

    std::string_view text_;
    std::size_t at_;
};

} // namespace

std::optional<std::vector<JsonSpan>> json_spans(std::string_view text, std::size_t from) {
    Scan scan(text, from);
    if (!scan.value(0, text.npos, 0))
        return std::nullopt;
    return std::move(scan.spans);
}

} // namespace wakesurf::fuzz
