#include "importer/sources/openfoam/openfoam_file.hpp"
#include "importer/sources/openfoam/openfoam_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

namespace wakesurf::importer {

using core::Error;

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Reads a dictionary from its beginning to its end. Empty and false mean: damaged.
class FoamDictionary {
  public:
    FoamDictionary(std::string_view text, int components)
        : text_(text), components_(static_cast<std::size_t>(components)) {}

    std::optional<FoamValues> read() {
        while (pass_blanks(), at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '{' || c == '}' || c == ';') {
                if (c == '}' && path_.empty())
                    return std::nullopt;
                if (c == '{')
                    path_.push_back(key_);
                if (c == '}')
                    path_.pop_back();
                key_.clear();
                ++at_;
            } else if (!take_word()) {
                return std::nullopt;
            }
        }
        return path_.empty() && !out_.inside.empty() ? std::optional(std::move(out_))
                                                     : std::nullopt;
    }

    bool of_other_machine() const { return of_other_machine_; }

    /// Says whether values that are wanted may stand elsewhere: those of another entry ($U0), or by a directive
    /// (#include "file", #calc).
    bool is_led_elsewhere() const { return led_elsewhere_; }

  private:
    void pass_blanks() {
        for (std::size_t end = 0; at_ < text_.size(); at_ = std::min(end, text_.size())) {
            if (text_.compare(at_, 2, "//") == 0)
                end = text_.find('\n', at_);
            else if (text_.compare(at_, 2, "/*") == 0)
                end = std::min(text_.find("*/", at_), text_.size() - 2) + 2;
            else if (blanks.find(text_[at_]) != std::string_view::npos || text_[at_] == '"')
                end = at_ + 1;
            else
                return;
        }
    }

    std::string_view word() {
        pass_blanks();
        const auto end = std::min(text_.find_first_of(" \t\r\n(){};\"", at_), text_.size());
        const auto out = text_.substr(at_, end - at_);
        at_ = end;
        return out;
    }

    bool take_word() {
        const auto here = word();
        if (here.empty()) {
            ++at_; // a bracket of a list that is not read
            return true;
        }
        if (here == "nonuniform")
            return take_list();
        if (here.front() == '$' || here.front() == '#')
            led_elsewhere_ =
                led_elsewhere_ || (key_.empty() && path_.empty()) || values() != nullptr;
        if (here == "uniform" && values() != nullptr) {
            const auto entry =
                text_.substr(at_, std::min(text_.find(';', at_), text_.size()) - at_);
            led_elsewhere_ = led_elsewhere_ || leads_elsewhere(entry);
            return take_numbers(1, components_, *values());
        }
        if (path_.size() == 1 && path_[0] == "FoamFile")
            take_header(here);
        if (key_.empty() &&
            here.front() == '#') // a directive, #includeEtc "...", ends with its line
            at_ = std::min(text_.find('\n', at_), text_.size());
        else if (key_.empty())
            key_ = here;
        else if (key_ == "type" && here == "noSlip" && in_patch())
            out_.patches[path_[1]].assign(components_, 0.0F);
        return true;
    }

    // Reads words of `format binary; arch "LSB;label=32;scalar=64";`.
    void take_header(std::string_view word) {
        binary_ = binary_ || (key_ == "format" && word == "binary");
        of_other_machine_ = of_other_machine_ || word == "MSB";
        if (word == "scalar=32")
            scalar_bytes_ = 4;
        if (word == "label=64")
            label_bytes_ = 8;
    }

    bool in_patch() const { return path_.size() == 2 && path_[0] == "boundaryField"; }

    // Returns the target of this entry's values; null if they are not wanted.
    std::vector<float>* values() {
        if (path_.empty() && key_ == "internalField")
            return &out_.inside;
        return in_patch() && key_ == "value" ? &out_.patches[path_[1]] : nullptr;
    }

    // Reads "List<vector> 12 ( ... )", "List<vector> 12{(0 0 0)}", "List<vector> 0;" or "0()".
    bool take_list() {
        pass_blanks();
        const auto type = text_.compare(at_, 5, "List<") == 0 ? word() : std::string_view();
        const auto number = word();
        led_elsewhere_ = led_elsewhere_ || (values() != nullptr && leads_elsewhere(number));
        std::size_t count = 0;
        const char* const end = number.data() + number.size();
        if (number.empty() || std::from_chars(number.data(), end, count).ptr != end)
            return false;
        pass_blanks();
        const char opens = at_ < text_.size() ? text_[at_] : ';';
        if (opens == ';')
            return count == 0;
        ++at_;
        const std::size_t numbers = numbers_in(type);
        std::vector<float> ignored;
        auto* const wanted = values();
        if (wanted != nullptr && count > 0 && numbers != components_)
            return false;
        auto& out = wanted != nullptr ? *wanted : ignored;
        if (opens == '{')
            return take_numbers(1, numbers, out) && closes('}');
        return (binary_ ? take_bytes(count, numbers, type == "List<label>", out)
                        : take_numbers(count, numbers, out)) &&
               closes(')');
    }

    static bool leads_elsewhere(std::string_view words) {
        return words.find_first_of("$#") != std::string_view::npos;
    }

    static std::size_t numbers_in(std::string_view type) {
        return type == "List<vector>"       ? 3
               : type == "List<tensor>"     ? 9
               : type == "List<symmTensor>" ? 6
                                            : 1;
    }

    bool closes(char bracket) {
        pass_blanks();
        return at_ < text_.size() && text_[at_++] == bracket;
    }

    // Reads `count` values; each stands in brackets if it has several numbers.
    bool take_numbers(std::size_t count, std::size_t numbers, std::vector<float>& out) {
        out.clear();
        for (std::size_t i = 0; i < count; ++i) {
            if (numbers > 1 && !closes('('))
                return false;
            for (std::size_t n = 0; n < numbers; ++n) {
                pass_blanks();
                double number = 0.0;
                const char* const begin = text_.data() + at_;
                const auto [end, error] =
                    std::from_chars(begin, text_.data() + text_.size(), number);
                if (error == std::errc::invalid_argument)
                    return false;
                if (error == std::errc::result_out_of_range) // from_chars leaves 0, of 1e999 too
                    number = std::strtod(begin, nullptr);
                at_ += static_cast<std::size_t>(end - begin);
                out.push_back(static_cast<float>(number));
            }
            if (numbers > 1 && !closes(')'))
                return false;
        }
        return true;
    }

    bool take_bytes(std::size_t count, std::size_t numbers, bool labels, std::vector<float>& out) {
        const std::size_t each = labels ? label_bytes_ : scalar_bytes_;
        if (count > (text_.size() - at_) / (numbers * each))
            return false;
        const std::size_t bytes = count * numbers * each;
        out.resize(labels ? 0 : count * numbers);
        const char* const begin = text_.data() + at_;
        if (each == 4 && !labels && !out.empty())
            std::memcpy(out.data(), begin, bytes);
        for (std::size_t i = 0; each == 8 && i < out.size(); ++i) {
            double number = 0.0;
            std::memcpy(&number, begin + i * each, each);
            out[i] = static_cast<float>(number);
        }
        at_ += bytes;
        return true;
    }

    std::string_view text_;
    std::size_t components_;
    std::size_t at_ = 0;
    std::vector<std::string> path_; ///< the names of the dictionaries around this position
    std::string key_;               ///< the first word of this entry
    bool binary_ = false;
    bool of_other_machine_ = false;
    bool led_elsewhere_ = false;
    std::size_t scalar_bytes_ = 8;
    std::size_t label_bytes_ = 4;
    FoamValues out_;
};

} // namespace

core::Result<FoamValues>
read_foam_values(const std::filesystem::path& file, const std::string& name, int components) {
    const auto text = foam_content(file, std::numeric_limits<std::size_t>::max());
    FoamDictionary dictionary(text ? std::string_view(*text) : std::string_view(), components);
    auto values = dictionary.read();
    if (dictionary.of_other_machine())
        return core::fail(Error::Code::Unsupported,
                          name + " is binary, of a machine with the other order of bytes",
                          "write it as text: foamFormatConvert");
    if (!values && dictionary.is_led_elsewhere())
        return core::fail(Error::Code::Unsupported,
                          name + " has values by the name of others ($...) or by a directive "
                                 "(#include, #calc ...), which are not looked up",
                          "write the numbers instead: foamDictionary -expand");
    if (!values)
        return core::fail(Error::Code::Corrupt,
                          name + " ends too early or is not a field of " +
                              std::to_string(components) + " number" +
                              (components == 1 ? "" : "s") + " a cell",
                          "copy it again");
    return std::move(*values);
}

} // namespace wakesurf::importer
