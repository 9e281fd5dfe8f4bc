#include "importer/step_message.hpp"

#include "store/whole_bytes.hpp"

#include <array>
#include <string>

namespace wakesurf::importer {

namespace {

struct Head {
    std::uint64_t index = 0;
    std::uint64_t failed = 0;
    std::uint64_t code = 0;
    std::uint64_t numbers = 0; ///< that follow, then the texts
    std::uint64_t message = 0; ///< characters
    std::uint64_t hint = 0;
};

template <class T>
auto bytes_of(T& value) {
    if constexpr (std::is_const_v<T>)
        return std::as_bytes(std::span(&value, 1));
    else
        return std::as_writable_bytes(std::span(&value, 1));
}

// Checksums have 32 bits: exact as doubles.
std::vector<double> numbers_of(const StepRecord& record) {
    std::vector<double> out{record.speed.lo, record.speed.hi};
    for (const Range& range : record.scalars)
        out.insert(out.end(), {range.lo, range.hi});
    out.insert(out.end(), record.checksums.begin(), record.checksums.end());
    return out;
}

StepRecord record_of(const std::vector<double>& numbers) {
    StepRecord record;
    const std::size_t columns = numbers.size() / 3;
    record.speed = {numbers.at(0), numbers.at(1)};
    for (std::size_t i = 1; i < columns; ++i)
        record.scalars.push_back({numbers.at(2 * i), numbers.at(2 * i + 1)});
    for (std::size_t i = 2 * columns; i < numbers.size(); ++i)
        record.checksums.push_back(static_cast<std::uint32_t>(numbers[i]));
    return record;
}

} // namespace

bool send(int pipe, const StepMessage& message) {
    Head head{message.index};
    std::vector<double> numbers;
    std::string texts;
    if (message.outcome) {
        numbers = numbers_of(*message.outcome);
        head.numbers = numbers.size();
    } else {
        const core::Error& error = message.outcome.error();
        texts = error.message + error.hint;
        head.failed = 1;
        head.code = static_cast<std::uint64_t>(error.code);
        head.message = error.message.size();
        head.hint = error.hint.size();
    }
    return store::write_whole(pipe, bytes_of(std::as_const(head))) &&
           store::write_whole(pipe, std::as_bytes(std::span<const double>(numbers))) &&
           store::write_whole(pipe, std::as_bytes(std::span<const char>(texts)));
}

std::optional<StepMessage> receive(int pipe) {
    Head head;
    if (!store::read_whole(pipe, bytes_of(head)))
        return std::nullopt;
    std::vector<double> numbers(head.numbers);
    std::string message(head.message, '\0');
    std::string hint(head.hint, '\0');
    if (!store::read_whole(pipe, std::as_writable_bytes(std::span(numbers))) ||
        !store::read_whole(pipe, std::as_writable_bytes(std::span(message))) ||
        !store::read_whole(pipe, std::as_writable_bytes(std::span(hint))))
        return std::nullopt;
    StepMessage out{static_cast<std::size_t>(head.index), StepRecord()};
    if (head.failed != 0)
        out.outcome =
            tl::unexpected(core::Error{static_cast<core::Error::Code>(head.code), message, hint});
    else
        out.outcome = record_of(numbers);
    return out;
}

} // namespace wakesurf::importer
