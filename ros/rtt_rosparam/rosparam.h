// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_ROSPARAM_H
#define RTT_ROSPARAM_ROSPARAM_H

#include <rtt/Property.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_rosparam/parameter_types.hpp>
#include <rtt_rosparam/resolution_policy.hpp>

#include <string>

namespace rtt_rosparam {

/**
 * The service rosparam of a component:
 *
 *     const auto rosparam = getProvider<rtt_rosparam::ROSParam>("rosparam");
 *     if (rosparam && rosparam->ready()) rosparam->getAllComponentPrivate();
 *
 * All operations execute in the caller's thread and wait for the ROS master, at most 5 s per call of it. They are not
 * real-time safe, and change properties of the component without a lock. What fails is logged, with the names of
 * parameter and property and of both types; nothing is thrown. X stands for the name of a policy, T for one of
 * RTT_ROSPARAM_TYPES.
 *
 * - getAllX(), setAllX(): all properties and those of services below. Parameters without a property stay.
 * - getX(name), setX(name), get(name, policy), set(name, policy): one property, or else a service.
 * - getTX(name, value), setTX(name, value): a value; the parameter stays what it is if it cannot be converted.
 * - addRosParamPropertyTX(name): a property of the component that is the parameter, see RosParamDataSource.
 */
class ROSParam : public RTT::ServiceRequester {
    typedef const std::string& Name;

public:
    typedef rtt_rosparam::ResolutionPolicy ResolutionPolicy;
    static constexpr int RELATIVE = rtt_rosparam::RELATIVE;
    static constexpr int ABSOLUTE = rtt_rosparam::ABSOLUTE;
    static constexpr int PRIVATE = rtt_rosparam::PRIVATE;
    static constexpr int COMPONENT = rtt_rosparam::COMPONENT;
    static constexpr int COMPONENT_PRIVATE = rtt_rosparam::COMPONENT_PRIVATE;
    static constexpr int COMPONENT_RELATIVE = rtt_rosparam::COMPONENT_RELATIVE;
    static constexpr int COMPONENT_ABSOLUTE = rtt_rosparam::COMPONENT_ABSOLUTE;

    /** As getProvider() makes it. */
    explicit ROSParam(RTT::TaskContext* owner) : RTT::ServiceRequester("rosparam", owner) {
        for (RTT::base::OperationCallerBaseInvoker* const caller : callers()) addOperationCaller(*caller);
    }

#define RTT_ROSPARAM_CALLER(signature, name) \
    RTT::OperationCaller<signature> name { #name }
#define RTT_ROSPARAM_GENERAL(Policy, policy, ...)             \
    RTT_ROSPARAM_CALLER(bool(), getAll##Policy);              \
    RTT_ROSPARAM_CALLER(bool(), setAll##Policy);              \
    RTT_ROSPARAM_CALLER(bool(Name), get##Policy);             \
    RTT_ROSPARAM_CALLER(bool(Name), set##Policy);
#define RTT_ROSPARAM_ONE(Policy, policy, Type, T)                 \
    RTT_ROSPARAM_CALLER(bool(Name, T&), get##Type##Policy);       \
    RTT_ROSPARAM_CALLER(void(Name, const T&), set##Type##Policy); \
    RTT_ROSPARAM_CALLER(RTT::Property<T>&(Name), addRosParamProperty##Type##Policy);
#define RTT_ROSPARAM_TYPED(Type, T)                    \
    RTT_ROSPARAM_ONE(, RELATIVE, Type, T)              \
    RTT_ROSPARAM_POLICIES(RTT_ROSPARAM_ONE, Type, T)

    RTT_ROSPARAM_CALLER(bool(), getAll);
    RTT_ROSPARAM_CALLER(bool(), setAll);
    RTT_ROSPARAM_CALLER(bool(Name), getParams);
    RTT_ROSPARAM_CALLER(bool(Name, unsigned), get);
    RTT_ROSPARAM_CALLER(bool(Name, unsigned), set);
    RTT_ROSPARAM_CALLER(bool(Name, Name), getParam);
    RTT_ROSPARAM_CALLER(bool(Name, Name), setParam);
    RTT_ROSPARAM_POLICIES(RTT_ROSPARAM_GENERAL, )
    RTT_ROSPARAM_TYPES(RTT_ROSPARAM_TYPED)

#undef RTT_ROSPARAM_CALLER
#undef RTT_ROSPARAM_GENERAL
#undef RTT_ROSPARAM_ONE

private:
    std::vector<RTT::base::OperationCallerBaseInvoker*> callers() {
#define RTT_ROSPARAM_GENERAL(Policy, policy, ...) &getAll##Policy, &setAll##Policy, &get##Policy, &set##Policy,
#define RTT_ROSPARAM_ONE(Policy, policy, Type, T) \
    &get##Type##Policy, &set##Type##Policy, &addRosParamProperty##Type##Policy,
        return {RTT_ROSPARAM_POLICIES(RTT_ROSPARAM_GENERAL, ) RTT_ROSPARAM_TYPES(RTT_ROSPARAM_TYPED) & getAll,
                &setAll, &getParams, &get, &set, &getParam, &setParam};
#undef RTT_ROSPARAM_GENERAL
#undef RTT_ROSPARAM_ONE
#undef RTT_ROSPARAM_TYPED
    }
};

}  // namespace rtt_rosparam

#endif
