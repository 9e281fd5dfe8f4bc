// Where many threads leave things for others to fetch, without a lock: no thread that leaves something waits for another. With a lock it
// would wait for one of lower priority that the kernel has set aside while it held it, tens of milliseconds on a busy machine.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace wakesurf::core {

/// Thread safety: everything may be called from any thread, but for the destructor.
template <class T>
class Mailbox {
  public:
    Mailbox() = default;

    ~Mailbox() { take(); }

    Mailbox(const Mailbox&) = delete;
    Mailbox& operator=(const Mailbox&) = delete;

    /// What a thread did before it left something is seen by the thread that takes it.
    void push(T item) {
        auto node = std::make_unique<Node>(Node{std::move(item), newest_.load(relaxed)});
        while (!newest_.compare_exchange_weak(node->before, node.get(), std::memory_order_release,
                                              relaxed)) {
        }
        node.release(); // the list's, until take()
    }

    /// All there is, what was left first goes first.
    std::vector<T> take() {
        std::vector<T> items;
        std::unique_ptr<Node> node(newest_.exchange(nullptr, std::memory_order_acquire));
        while (node) {
            items.push_back(std::move(node->item));
            node.reset(node->before);
        }
        std::reverse(items.begin(), items.end());
        return items;
    }

    /// As it was a moment ago.
    bool empty() const { return newest_.load(relaxed) == nullptr; }

  private:
    static constexpr auto relaxed = std::memory_order_relaxed;

    struct Node {
        T item;
        Node* before;
    };

    std::atomic<Node*> newest_{nullptr};
};

} // namespace wakesurf::core
