#include "server/service/session/records/clean_names.hpp"

#include "core/base/plain_text.hpp"

#include <type_traits>
#include <variant>

namespace wakesurf::server {

void clean_names(Record& record) {
    const auto clean = [](std::string& name) { name = core::display_name(name, name.size()); };
    std::visit(
        [&](auto& each) {
            using Kind = std::decay_t<decltype(each)>;
            if constexpr (std::is_same_v<Kind, protocol::AnnotationRecord>)
                each.text = core::display_lines(each.text, each.text.size());
            else if constexpr (!std::is_same_v<Kind, protocol::SurfaceRecord>)
                clean(each.name);
            if constexpr (std::is_same_v<Kind, protocol::AnnotationRecord> ||
                          std::is_same_v<Kind, protocol::RakeRecord>)
                clean(each.author);
        },
        record);
}

} // namespace wakesurf::server
