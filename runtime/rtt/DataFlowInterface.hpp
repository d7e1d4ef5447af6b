// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The ports of a service, and so of a component.
#ifndef ORO_DATA_FLOW_INTERFACE_HPP
#define ORO_DATA_FLOW_INTERFACE_HPP

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/base/PortInterface.hpp>

#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>

#include <map>
#include <string>
#include <vector>

namespace RTT {
class Service;
class TaskContext;

/** Refers to ports, does not own them. Only one thread at a time may add and remove ports; data may flow through them
    meanwhile. Only dataOnPort() is real-time safe. */
class RTT_API DataFlowInterface {
public:
    typedef std::vector<base::PortInterface*> Ports;
    typedef std::vector<std::string> PortNames;
    typedef boost::function<void(base::PortInterface*)> SlotFunction;

    explicit DataFlowInterface(Service* parent = nullptr);
    ~DataFlowInterface();
    DataFlowInterface(const DataFlowInterface&) = delete;
    DataFlowInterface& operator=(const DataFlowInterface&) = delete;

    /** The component; null if the service belongs to none. */
    TaskContext* getOwner() const;
    Service* getService() const { return service_; }

    /** Adds a port and a service of the same name with its operations. Replaces a port or service of that name, with a
        warning. With `name`, renames the port (unless it is connected). */
    base::PortInterface& addPort(const std::string& name, base::PortInterface& port);
    base::PortInterface& addPort(base::PortInterface& port);
    /** The same for a port whose new samples wake the component. They call `callback` in the component's thread or,
        without one, trigger the component. */
    base::InputPortInterface& addEventPort(const std::string& name, base::InputPortInterface& port,
                                           const SlotFunction& callback = SlotFunction());
    base::InputPortInterface& addEventPort(base::InputPortInterface& port,
                                           const SlotFunction& callback = SlotFunction());
    /** Makes a port of this component an event port, or replaces its callback; it stays connected. False, with an error
        logged, if the port is not of this component. */
    bool setEventPort(base::InputPortInterface& port, const SlotFunction& callback = SlotFunction());
    /** The same without a service. */
    base::PortInterface& addLocalPort(base::PortInterface& port);
    base::InputPortInterface& addLocalEventPort(base::InputPortInterface& port,
                                                const SlotFunction& callback = SlotFunction());

    /** Disconnects the port and removes its callback and its service, if it has them. Ignores unknown names. */
    void removePort(const std::string& name);
    void removeLocalPort(const std::string& name);
    /** Removes the port without disconnecting it; for its destructor. */
    void forgetPort(base::PortInterface& port);
    /** Removes all ports and their services, without disconnecting them. */
    void clear();

    /** In the order of adding. */
    Ports getPorts() const { return ports_; }
    PortNames getPortNames() const;
    /** Null if there is none. */
    base::PortInterface* getPort(const std::string& name) const;
    template <class Type>
    Type* getPortType(const std::string& name) const {
        return dynamic_cast<Type*>(getPort(name));
    }
    std::string getPortDescription(const std::string& name) const;
    bool setPortDescription(const std::string& name, const std::string& description);

    /** Called in the writer's thread when an event port has a new sample. Real-time safe. */
    void dataOnPort(base::PortInterface* port);

protected:
    /** For a service that leaves its component: its event ports no longer wake that. */
    void silencePorts();

private:
    void replacePort(const std::string& name);
    void setupCallback(base::InputPortInterface& port, const SlotFunction& callback);
    void takeOut(base::PortInterface& port);
    void removeObject(base::PortInterface& port);

    Service* service_;
    Ports ports_;
    std::map<base::PortInterface*, boost::shared_ptr<Service>> objects_;  // services made by addPort()
};

}  // namespace RTT

#endif
