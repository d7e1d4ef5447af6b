// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's: nobody interrupts here.
#ifndef OROFORGE_MODEL_ENGINE_INTERRUPTION_HPP
#define OROFORGE_MODEL_ENGINE_INTERRUPTION_HPP

#include <cstdint>
#include <stdexcept>

namespace RTT {
namespace internal {

struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Interruption {
    bool asked() const { return false; }
    static const Interruption* ofScript() { return nullptr; }
    static Interruption* ofThisThread() { return nullptr; }
    struct Region {
        enum Kind { Native };
        Region(Interruption*, Kind) {}
        ~Region() {}
    };
    static constexpr std::int64_t kLook = 1;
};

}  // namespace internal
}  // namespace RTT

#endif
