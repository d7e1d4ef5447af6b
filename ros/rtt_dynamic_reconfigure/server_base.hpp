// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all servers of parameters have in common.
#ifndef RTT_DYNAMIC_RECONFIGURE_SERVER_BASE_HPP
#define RTT_DYNAMIC_RECONFIGURE_SERVER_BASE_HPP

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <rtt/PropertyBag.hpp>
#include <rtt/Service.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace rtt_dynamic_reconfigure {

/** The limits and defaults of parameters, which are properties of the server. */
struct Limits {
    RTT::PropertyBag &min, &max, &defaults;
};

/** How the properties of a component are a configuration. Its functions are called while nobody else executes the
    component. */
class ConfigModel {
public:
    virtual ~ConfigModel();
    /** Describes the parameters. Keeps those limits that there are already. */
    virtual void describe(const RTT::PropertyBag& properties, Limits& limits,
                          dynamic_reconfigure::ConfigDescription& description) = 0;
    /** Sets min and max of the description from the limits. */
    virtual void readLimits(const Limits& limits, dynamic_reconfigure::ConfigDescription& description) = 0;
    /** The present values. */
    virtual void read(const RTT::PropertyBag& properties, dynamic_reconfigure::Config& config) = 0;
    /** Puts new values into a bag for the component. False if that fails. */
    virtual bool fill(const dynamic_reconfigure::Config& config, std::uint32_t level, const RTT::PropertyBag& properties,
                      RTT::PropertyBag& bag) = 0;
    /** The component has taken the values of the last fill(). */
    virtual void accept() {}
};

/**
 * A service of a component that lets clients of dynamic_reconfigure change its properties. The operations of the service
 * and the functions here may be called by any thread. They wait until the component's thread has done its part, up to
 * 5 s, and for the ROS master; not real-time safe.
 *
 * A request of a client is executed in the component's thread: either all values change or none does. While nobody
 * executes the component, the thread of roscpp does it.
 */
class ServerBase : public RTT::Service {
public:
    ~ServerBase() override;

    /** Offers `set_parameters` in a namespace, and publishes the parameters. `~NAME` is one in the private namespace of
        the node; empty stands for `~COMPONENT`, or `~` for the component Deployer. False, with an error logged, if that
        fails. What was advertised before is not any more. */
    bool advertise(const std::string& ns = "");
    /** Takes them back. Waits for requests that are being executed, so an operation of the component that such a request
        calls cannot do that: it gets an error. */
    void shutdown();
    /** Publishes the present values. False if they are not advertised. For components that change their properties
        themselves. */
    bool updated();
    /** Looks at the component's properties again, and publishes them with the limits. False, with an error logged, if
        that fails. For components that add or remove properties, and after a change of limits. */
    bool refresh();

protected:
    ServerBase(const std::string& name, RTT::TaskContext* owner, std::unique_ptr<ConfigModel> model);

private:
    struct Parts;
    bool isFine(bool succeeded, const char* what, const std::string& why) const;
    bool set(const dynamic_reconfigure::Config& request, dynamic_reconfigure::Config& response);

    const std::unique_ptr<ConfigModel> model_;
    const std::unique_ptr<Parts> parts_;
};

}  // namespace rtt_dynamic_reconfigure

#endif
