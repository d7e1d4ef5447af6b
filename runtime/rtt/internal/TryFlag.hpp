// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_TRY_FLAG_HPP
#define ORO_INTERNAL_TRY_FLAG_HPP

#include <atomic>

namespace RTT {
namespace internal {

/** Raises a flag until the end of the scope, unless somebody else has raised it: then it converts to false. */
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

/** Keeps an activity active within initialize() and finalize(), which may throw: not any more at the end of the scope. */
class ActiveWhile {
public:
    explicit ActiveWhile(std::atomic<bool>& active) noexcept : active_(&active) { active = true; }
    ~ActiveWhile() {
        if (active_) *active_ = false;
    }
    ActiveWhile(const ActiveWhile&) = delete;
    ActiveWhile& operator=(const ActiveWhile&) = delete;
    /** It stays active. */
    void stay() noexcept { active_ = nullptr; }

private:
    std::atomic<bool>* active_;
};

}  // namespace internal
}  // namespace RTT
#endif
