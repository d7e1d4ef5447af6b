// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Events in which threads compose what they log.
#ifndef OROFORGE_LOGGING_EVENT_POOL_HPP
#define OROFORGE_LOGGING_EVENT_POOL_HPP

#include <ocl/LoggingEvent.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace OCL::logging {

/**
 * Events with memory for messages of kMessage characters. A thread takes one while it logs; each thread tries another
 * one first. Claiming and giving back are lock-free and allocate nothing.
 */
class EventPool {
public:
    static constexpr std::size_t kEvents = 64;
    static constexpr std::size_t kMessage = 256;
    static constexpr std::size_t kCategory = 64;

    /** The pool of the process. The first call makes it; it is never destroyed, because threads log until the end. */
    static EventPool& instance();

    /** One event; null if as many threads as there are events are logging at this moment. */
    class Claim {
    public:
        explicit Claim(EventPool& pool) noexcept;
        ~Claim() {
            if (event_) place_->store(event_, std::memory_order_release);
        }
        Claim(const Claim&) = delete;
        Claim& operator=(const Claim&) = delete;
        explicit operator bool() const noexcept { return event_ != nullptr; }
        LoggingEvent& operator*() const noexcept { return *event_; }
        LoggingEvent* operator->() const noexcept { return event_; }

    private:
        std::atomic<LoggingEvent*>* place_ = nullptr;
        LoggingEvent* event_ = nullptr;
    };

private:
    EventPool();
    struct alignas(64) Place {
        std::atomic<LoggingEvent*> event{nullptr};
        LoggingEvent own;
    };
    std::array<Place, kEvents> places_;
};

}  // namespace OCL::logging

#endif
