// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_SCRIPT_END_HPP
#define OROFORGE_DEPLOYER_SCRIPT_END_HPP

#include <rtt/internal/engine/interruption.hpp>
#include <rtt/os/SignalCatcher.hpp>

#include <thread>

namespace OCL::deploy {

/**
 * While it exists, interrupts scripts of its thread two seconds after a signal that ends the program: by then a script
 * that reacts to signals has ended, and another might never end. C++ code is not interrupted.
 */
class ScriptEnd {
public:
    explicit ScriptEnd(const RTT::os::SignalCatcher& ending);
    ~ScriptEnd();
    ScriptEnd(const ScriptEnd&) = delete;
    ScriptEnd& operator=(const ScriptEnd&) = delete;

private:
    void watch(int ending);

    RTT::internal::Interruption interruption_{false};
    int over_[2];  // a pipe; the destructor closes its second end
    std::thread thread_;
};

}  // namespace OCL::deploy

#endif
