#include "server/sessions/records/change_log.hpp"

#include "server/base/limits.hpp"

namespace wakesurf::server {

namespace {

using Key = std::pair<std::string, std::string>;

Key log_key(const protocol::RakeRecord& record) {
    return {"rake", record.rake};
}

Key log_key(const protocol::SurfaceRecord& record) {
    return {"surface", record.surface};
}

Key log_key(const protocol::SliceRecord& record) {
    return {"slice", record.slice};
}

Key log_key(const protocol::LinesRecord& record) {
    return {"lines", record.lines};
}

Key log_key(const protocol::BookmarkRecord& record) {
    return {"bookmark", record.bookmark};
}

Key log_key(const protocol::AnnotationRecord& record) {
    return {"annotation", record.annotation};
}

Key log_key(const protocol::ClockRecord&) {
    return {"clock", ""};
}

Key log_key(const SessionName& record) {
    return {"session", record.session};
}

Key log_key(const DeletedRecord& record) {
    return {std::string(record.type), record.id};
}

} // namespace

void ChangeLog::start(std::uint64_t seq) {
    changes_.clear();
    newest_.clear();
    oldest_ = seq;
    seq_ = seq;
}

void ChangeLog::add(std::uint64_t seq, std::span<const Patch> patches) {
    seq_ = seq;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Place place{seq, i};
        Key key = std::visit([](const auto& each) { return log_key(each); }, patches[i]);
        const auto [known, fresh] = newest_.try_emplace(std::move(key), place);
        if (!fresh)
            changes_.erase(std::exchange(known->second, place));
        changes_.emplace(place, patches[i]);
    }
    while (changes_.size() > limits::changes) {
        const auto first = changes_.begin();
        oldest_ = first->first.first;
        newest_.erase(std::visit([](const auto& each) { return log_key(each); }, first->second));
        changes_.erase(first);
    }
}

std::optional<std::vector<Patch>> ChangeLog::since(std::uint64_t seq) const {
    if (seq < oldest_ || seq > seq_)
        return std::nullopt;
    std::vector<Patch> out;
    for (auto each = changes_.upper_bound({seq, ~std::size_t{0}}); each != changes_.end(); ++each)
        out.push_back(each->second);
    return out;
}

} // namespace wakesurf::server
