// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_SCRIPT_END_HPP
#define OROFORGE_DEPLOYER_SCRIPT_END_HPP

#include "../deployment/signals.hpp"

#include <rtt/internal/Interruption.hpp>

#include <thread>

namespace OCL::deploy {

/**
 * While one lives, what scripts of its thread execute is interrupted when a signal that ends the program came two seconds ago: by then
 * a script that knows of signals has ended, and one that does not might never. C++ code is not interrupted.
 */
class ScriptEnd {
public:
    explicit ScriptEnd(const SignalCatcher& ending);
    ~ScriptEnd();
    ScriptEnd(const ScriptEnd&) = delete;
    ScriptEnd& operator=(const ScriptEnd&) = delete;

private:
    void watch(int ending);

    RTT::internal::Interruption interruption_{false};
    int over_[2];  // a pipe, whose second end is closed when this is destroyed
    std::thread thread_;
};

}  // namespace OCL::deploy

#endif
