#include "server/rpc/method_table.hpp"

#include "server/limits.hpp"

#include <fmt/format.h>

#include <iterator>

namespace wakesurf::server {

std::vector<Method> method_table() {
    std::vector<Method> table;
    for (auto part :
         {server_methods, dataset_methods, session_methods, session_keeping_methods, share_methods,
          presence_methods, rake_methods, surface_methods, subscription_methods, wait_methods,
          bookmark_methods, annotation_methods, history_methods, time_methods}) {
        auto methods = part();
        std::move(methods.begin(), methods.end(), std::back_inserter(table));
    }
    return table;
}

Parameter session_parameter() {
    return {"session", R"({"type":"string"})", false,
            "may be left out on a WebSocket that has joined one"};
}

Parameter default_parameter() {
    return {"default", R"({"type":"boolean","default":false})", false,
            "true: only if no one has edited the session and there is none yet; it counts as no "
            "edit, so "
            "undo does not turn it"};
}

Parameter gesture_parameter() {
    return {
        "gesture",
        fmt::format(R"({{"type":"string","minLength":1,"maxLength":{}}})", limits::gesture_bytes),
        false,
        "a name for what the user does; edits that follow each other with the same one are one "
        "step of undo"};
}

} // namespace wakesurf::server
