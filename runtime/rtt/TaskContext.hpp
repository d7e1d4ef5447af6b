// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TASK_CONTEXT_HPP
#define ORO_TASK_CONTEXT_HPP

#include <rtt/DataFlowInterface.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/Service.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/flow/port_callbacks.hpp>

#include <boost/make_shared.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace RTT {

/**
 * A component: a life cycle (base::TaskCore), an interface of ports, operations, properties, attributes and services,
 * an activity that executes it, and peers with names.
 *
 * Derive from it, add the interface in the constructor, override the hooks. A component whose hooks or operations use
 * its members calls stopForGood() first in its destructor, because its thread executes operations even after stop(). A
 * ComponentLoader stops the components that it unloads for good before any destructor runs.
 *
 * Only one thread at a time may change the interface or the activity, which is not real-time safe; others may call
 * operations, send, trigger and write to the ports meanwhile. Any thread may change peers. Any thread, even its own
 * (see ExecutionEngine), may destroy a component while others call operations that it executes: those calls fail.
 */
class RTT_API TaskContext : public base::TaskCore {
public:
    typedef std::vector<std::string> PeerList;

    /** Starts with a non-periodic activity of its own, which is running when this returns. */
    explicit TaskContext(const std::string& name, TaskState initial_state = Stopped);
    ~TaskContext() override;

    const std::string& getName() const override;

    /** Takes ownership, stops the old activity and starts the new one, which executes items queued meanwhile. Null
        gives a new default activity; the current one changes nothing. False, with an error logged, while running,
        within a step of the component, and if the old one does not stop. Blocks until the current step is over. */
    bool setActivity(base::ActivityInterface* new_act);
    base::ActivityInterface* getActivity();
    template <class ActivityType>
    ActivityType* getActivity() {
        return dynamic_cast<ActivityType*>(getActivity());
    }

    bool start() override;
    bool stop() override;
    /**
     * Stops the component and its activity; from then on no other thread executes its operations, callbacks or hooks:
     * pending calls fail, new ones are refused. Call it first in a destructor, or before deleting a component, in the
     * same thread; the component can then only be destroyed. Blocks until threads that are executing the component have
     * finished. If `limit` is not negative, it gives up after that many seconds: false, with an error logged. Later
     * calls only wait for threads that are left. Makes no thread. Logs exceptions of hooks and throws none.
     *
     * Does not wait for a ClientThread operation that a caller is executing itself, without send().
     */
    bool stopForGood(Seconds limit = -1) noexcept;
    virtual void clear();
    /** True if the component can be used; for subclasses. */
    virtual bool ready();

    // --- peers ---
    /** Makes `peer` known here under its name or `alias`; false if it is null or the name is taken. */
    virtual bool addPeer(TaskContext* peer, std::string alias = "");
    virtual void removePeer(const std::string& name);
    virtual void removePeer(TaskContext* peer);
    /** Makes both known to each other; false if one already has a peer of that name. */
    virtual bool connectPeers(TaskContext* peer);
    virtual void disconnectPeers(const std::string& name);
    /** Disconnects all ports and all peers, also components that have this as a peer. */
    virtual void disconnect();
    /** In alphabetical order. */
    virtual PeerList getPeerList() const;
    virtual bool hasPeer(const std::string& name) const;
    /** Null if there is none. */
    virtual TaskContext* getPeer(const std::string& name) const;
    /** The names of the peers with the ways to their engines, for code that uses peers while others destroy them. */
    typedef std::vector<std::pair<std::string, boost::intrusive_ptr<const internal::EngineGate>>> PeerGates;
    PeerGates getPeerGates() const;

    /** Connects ports of equal name and opposite direction, with the default policy; false if one of them failed. */
    virtual bool connectPorts(TaskContext* peer);
    /** Connects the services that each requires with those that the other provides; false if one of them failed. */
    virtual bool connectServices(TaskContext* peer);

    // --- services ---
    Service::shared_ptr provides() { return service_; }
    Service::shared_ptr provides(const std::string& name) { return service_->provides(name); }
    ServiceRequester::shared_ptr requires_() { return requester_; }
    ServiceRequester::shared_ptr requires_(const std::string& name) { return requester_->requires_(name); }
#if __cplusplus < 202002L
    ServiceRequester::shared_ptr requires() { return requester_; }
    ServiceRequester::shared_ptr requires(const std::string& name) { return requester_->requires_(name); }
#endif
    /** True if the component has the service or a plugin could load it into this component. */
    virtual bool loadService(const std::string& name);
    /** The service `name`, by a requester class (made as ServiceType(this) and connected) or as the service class
        itself. Loads the service if necessary; null if that fails. */
    template <class ServiceType>
    boost::shared_ptr<ServiceType> getProvider(const std::string& name) {
        if (!loadService(name)) return nullptr;
        if constexpr (std::is_base_of_v<Service, ServiceType>) {
            return boost::dynamic_pointer_cast<ServiceType>(provides(name));
        } else {
            ServiceRequester::shared_ptr& cached = providers_[name];
            if (!cached) {
                cached = boost::make_shared<ServiceType>(this);
                cached->connectTo(provides(name));
            }
            return boost::dynamic_pointer_cast<ServiceType>(cached);
        }
    }
    template <class ServiceType>
    boost::shared_ptr<ServiceType> getProvider() {
        return boost::dynamic_pointer_cast<ServiceType>(service_);
    }

    // --- interface of the main service ---
    OperationInterface* operations() { return service_.get(); }
    ConfigurationInterface* attributes() { return service_.get(); }
    DataFlowInterface* ports() { return service_.get(); }
    const DataFlowInterface* ports() const { return service_.get(); }
    PropertyBag* properties() { return service_->properties(); }
    const PropertyBag* properties() const { return service_->properties(); }

    template <class... Arguments>
    auto& addOperation(const std::string& name, Arguments... arguments) {
        return service_->addOperation(name, arguments...);
    }
    template <class Signature>
    Operation<Signature>& addOperation(Operation<Signature>& operation) {
        return service_->addOperation(operation);
    }
    template <class... Arguments>
    auto& addEventOperation(const std::string& name, Arguments... arguments) {
        return service_->addEventOperation(name, arguments...);
    }
    template <class Signature>
    Operation<Signature>& addEventOperation(Operation<Signature>& operation) {
        return service_->addEventOperation(operation);
    }
    /** Null, with a warning logged, if there is none. */
    OperationInterfacePart* getOperation(const std::string& name) { return service_->getOperation(name); }

    template <class T>
    bool addAttribute(const std::string& name, T& attribute) {
        return service_->addAttribute(name, attribute).ready() && !name.empty();
    }
    bool addAttribute(base::AttributeBase& attribute) { return service_->addAttribute(attribute); }
    template <class T>
    bool addConstant(const std::string& name, const T& constant) {
        return service_->addConstant(name, constant).ready() && !name.empty();
    }
    template <class T>
    bool addConstant(const std::string& name, Constant<T>& constant) {
        return service_->addConstant(name, constant).ready() && !name.empty();
    }
    template <class T, std::enable_if_t<!std::is_lvalue_reference<T>::value, int> = 0>
    bool addConstant(const std::string& name, T&& value) {
        return service_->addConstant(name, std::forward<T>(value)).ready() && !name.empty();
    }
    bool addConstant(base::AttributeBase& constant) { return service_->addConstant(constant); }
    base::AttributeBase* getAttribute(const std::string& name) const { return service_->getAttribute(name); }
    template <class T>
    auto& addProperty(const std::string& name, T& property) {
        return service_->addProperty(name, property);
    }
    bool addProperty(base::PropertyBase& property) { return service_->addProperty(property); }
    base::PropertyBase* getProperty(const std::string& name) const { return service_->getProperty(name); }

    base::PortInterface& addPort(const std::string& name, base::PortInterface& port) {
        return ports()->addPort(name, port);
    }
    base::PortInterface& addPort(base::PortInterface& port) { return ports()->addPort(port); }
    typedef DataFlowInterface::SlotFunction SlotFunction;
    base::InputPortInterface& addEventPort(const std::string& name, base::InputPortInterface& port,
                                           SlotFunction callback = SlotFunction()) {
        return ports()->addEventPort(name, port, callback);
    }
    base::InputPortInterface& addEventPort(base::InputPortInterface& port, SlotFunction callback = SlotFunction()) {
        return ports()->addEventPort(port, callback);
    }
    base::PortInterface* getPort(const std::string& name) const { return ports()->getPort(name); }

protected:
    /** Like setActivity(), without the checks; ignores null. */
    void forceActivity(base::ActivityInterface* new_act);
    /** Decides, in the writer's thread, whether data on an event port wakes this component. Default: isRunning(). */
    virtual bool dataOnPortHook(base::PortInterface* port);
    void dataOnPortCallback(base::PortInterface* port) override;

private:
    friend class DataFlowInterface;
    friend class Service;
    static void portStep(base::TaskCore& task, base::PortInterface* port);
    void callbackOf(base::PortInterface* port);
    void dataOnPort(base::PortInterface* port);
    void setDataOnPortCallback(base::InputPortInterface* port, const SlotFunction& callback);
    void dataOnPortRemoved(base::PortInterface* port);

    static bool isStandardOperation(const std::string& name);
    void addStandardOperations();
    void exchangeActivity(base::ActivityInterface::shared_ptr next);
    bool endExecution(Seconds limit = -1);
    void releaseActivity();
    void releaseProviders();
    void forgetPeer(const std::string& name);
    void forgetPeer(TaskContext* peer);
    void leaveAll();

    Service::shared_ptr service_;
    ServiceRequester::shared_ptr requester_;
    std::map<std::string, ServiceRequester::shared_ptr> providers_;
    // One lock guards these of all components, because each change concerns two components.
    std::map<std::string, TaskContext*> peers_;
    std::vector<TaskContext*> users_;  // components that have this as a peer
    internal::PortCallbacks port_callbacks_;
    base::ActivityInterface::shared_ptr activity_;
};

/** Makes both known to each other. */
inline bool connectPeers(TaskContext* a, TaskContext* b) { return a->connectPeers(b); }
/** Connects ports of equal names. */
inline bool connectPorts(TaskContext* a, TaskContext* b) { return a->connectPorts(b); }

}  // namespace RTT

#include <rtt/usual_includes.hpp>

#endif
