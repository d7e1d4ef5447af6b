// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: with the checker's futex.
#ifndef OROFORGE_MODEL_PRIORITY_LOCK_HPP
#define OROFORGE_MODEL_PRIORITY_LOCK_HPP

namespace RTT {
namespace os {
namespace detail {

class PriorityLock {
public:
    explicit PriorityLock(std::atomic<std::uint32_t>& word) : word_(word) {
        std::uint32_t nobody = 0;
        while (!word_.compare_exchange_strong(nobody, 1)) {
            model::futexWait(word_, 1);
            nobody = 0;
        }
    }
    ~PriorityLock() {
        word_.store(0);
        model::futexWake(word_, ~0u);
    }

private:
    std::atomic<std::uint32_t>& word_;
};

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
