// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's: no script collects reasons here.
#ifndef OROFORGE_MODEL_ENGINE_FAILURE_REPORT_HPP
#define OROFORGE_MODEL_ENGINE_FAILURE_REPORT_HPP

namespace RTT {
namespace internal {

struct FailureReport {
    struct Pause {
        Pause() {}
        ~Pause() {}
    };
};

}  // namespace internal
}  // namespace RTT

#endif
