// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// For code that can show users why a value is not converted.
#ifndef OROFORGE_REFUSAL_WATCH_HPP
#define OROFORGE_REFUSAL_WATCH_HPP

#include <rtt/rtt-config.h>

#include <string>
#include <utility>

namespace RTT {
namespace types {
namespace detail {

/** While it exists, conversions that fail in this thread may leave the reason here. Real-time safe until one does. */
class RTT_API RefusalWatch {
public:
    RefusalWatch();
    ~RefusalWatch();
    RefusalWatch(const RefusalWatch&) = delete;
    RefusalWatch& operator=(const RefusalWatch&) = delete;

    /** The innermost watch of this thread, or null. */
    static RefusalWatch* current();
    void note(std::string reason) { reason_ = std::move(reason); }
    /** Empty if there is none. */
    const std::string& reason() const { return reason_; }
    /** Takes the reason from the innermost watch of this thread, or returns `otherwise`. */
    static std::string takeReason(const char* otherwise);

private:
    RefusalWatch* const outer_;
    std::string reason_;
};

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
