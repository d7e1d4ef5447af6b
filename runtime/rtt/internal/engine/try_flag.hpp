// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_TRY_FLAG_HPP
#define ORO_INTERNAL_TRY_FLAG_HPP

#include <atomic>

namespace RTT {
namespace internal {

/** Raises a flag until the end of the scope; converts to false if the flag is raised already. */
class TryFlag {
public:
    explicit TryFlag(std::atomic<bool>& flag) noexcept : flag_(flag.exchange(true) ? nullptr : &flag) {}
    ~TryFlag() {
        if (flag_) *flag_ = false;
    }
    TryFlag(const TryFlag&) = delete;
    TryFlag& operator=(const TryFlag&) = delete;
    explicit operator bool() const noexcept { return flag_ != nullptr; }

private:
    std::atomic<bool>* const flag_;
};

/** Keeps an activity active until the end of the scope, for initialize() and finalize(), which may throw. */
class ActiveWhile {
public:
    explicit ActiveWhile(std::atomic<bool>& active) noexcept : active_(&active) { active = true; }
    ~ActiveWhile() {
        if (active_) *active_ = false;
    }
    ActiveWhile(const ActiveWhile&) = delete;
    ActiveWhile& operator=(const ActiveWhile&) = delete;
    /** Keeps it active after the scope, too. */
    void stay() noexcept { active_ = nullptr; }

private:
    std::atomic<bool>* active_;
};

}  // namespace internal
}  // namespace RTT
#endif
