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
     * Sets the value from the parameter if that is not the one from which the value is already. True if it did; the
     * caller must then take the value, because the next call takes it as known.
     *
     * False if the value is left as it is, or if the parameter is not set or cannot be converted; the value is then
     * some valid value. That is logged as an error, once until the reason changes.
     *
     * The first call asks the master, and blocks for up to 5 s if it does not answer. Later calls read roscpp's cache,
     * which the master keeps up to date; of a struct, the master is asked again after a member has changed. Without
     * ros::start() there is no cache, so each call asks the master.
     */
    bool read(void* value);
    /** Sets the parameter, a struct by its members so that foreign ones stay, and waits for the master, at most 5 s for
        each call of it. False, with an error logged, if that fails. */
    bool write(const void* value);

    /** From now on somebody may change the value through a reference. */
    void lend(const void* value);
    /** After lend(): sets the parameter if the value has changed since lend(), settle() or read(). */
    void settle(const void* value);

private:
    struct State;
    void report(const std::string& problem);

    std::string name_;
    const std::type_info* type_;
    std::unique_ptr<State> state_;
};

}  // namespace rtt_rosparam

#endif
