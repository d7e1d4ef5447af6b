// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_PARAMETER_BINDING_HPP
#define RTT_ROSPARAM_PARAMETER_BINDING_HPP

#include <memory>
#include <string>
#include <typeinfo>

namespace rtt_rosparam {

/**
 * A parameter whose value is one of a C++ type: a number, a text, a sequence of them, or any type of a typekit that is
 * loaded. Two threads must not use one binding at the same time. Not real-time safe.
 */
class ParameterBinding {
public:
    ParameterBinding(const std::string& name, const std::type_info& type);
    ~ParameterBinding();
    ParameterBinding(const ParameterBinding&) = delete;
    ParameterBinding& operator=(const ParameterBinding&) = delete;

    const std::string& name() const { return name_; }

    /**
     * Sets the value from the parameter: from roscpp's cache, which the master keeps up to date, after the first time.
     * That asks the master and blocks up to 5 s if it does not answer; so do all others if ros::start() was not called.
     * False, with an error logged if it is another one
     * than before, if the parameter is not set or cannot be converted. The value is then some valid value.
     */
    bool read(void* value);
    /** Sets the parameter, and waits for the master. False, with an error logged, if that fails. */
    bool write(const void* value);

    /** From now on somebody may change the value through a reference. */
    void lend(const void* value);
    /** After lend(): sets the parameter if the value has changed since lend(), settle() or read(). */
    void settle(const void* value);

private:
    struct Lent;
    bool report(const std::string& problem);

    std::string name_;
    const std::type_info* type_;
    std::unique_ptr<Lent> lent_;  // null if nobody has a reference
    bool isCached_ = false;
    std::string reported_;
};

}  // namespace rtt_rosparam

#endif
