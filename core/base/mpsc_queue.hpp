// A lock-free queue that many threads push to, and one, or any, empties at once: no producer waits for
// another. With a lock it would wait for one of lower priority that the kernel has preempted while it held
// the lock, tens of milliseconds on a busy machine.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace wakesurf::core {

/// Keeps items in the order in which they were pushed. Thread safety: everything may be called from any
/// thread, but for the destructor.
template <class T>
class MpscQueue {
  public:
    MpscQueue() = default;

    ~MpscQueue() { take(); }

    MpscQueue(const MpscQueue&) = delete;
    MpscQueue& operator=(const MpscQueue&) = delete;

    /// Adds an item. What a thread wrote before push() is visible to the thread that takes the item.
    void push(T item) {
        auto node = std::make_unique<Node>(Node{std::move(item), newest_.load(relaxed)});
        while (!newest_.compare_exchange_weak(node->before, node.get(), std::memory_order_release,
                                              relaxed)) {
        }
        node.release(); // the list's, until take()
    }

    /// Takes all items, the oldest first.
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

    /// Returns whether it was empty a moment ago.
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
