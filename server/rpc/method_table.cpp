#include "server/rpc/method_table.hpp"

#include <iterator>

namespace wakesurf::server {

std::vector<Method> method_table() {
    std::vector<Method> table;
    for (auto part :
         {server_methods, dataset_methods, family_methods, session_methods, session_keeping_methods,
          share_methods, presence_methods, rake_methods, surface_methods, subscription_methods,
          wait_methods, bookmark_methods, annotation_methods, history_methods, time_methods}) {
        auto methods = part();
        std::move(methods.begin(), methods.end(), std::back_inserter(table));
    }
    return table;
}

} // namespace wakesurf::server
