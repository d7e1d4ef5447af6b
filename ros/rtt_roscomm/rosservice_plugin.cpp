// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Logger.hpp>
#include <rtt/internal/dotted_name.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt_roscomm/rtt_rosservice_registry_service.h>

#include <list>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace rtt_roscomm {

namespace {

/** The path of a caller, or an operation, below a component; null if there is none. */
RTT::base::OperationCallerBaseInvoker* findCaller(RTT::TaskContext& component, const std::string& path) {
    RTT::ServiceRequester::shared_ptr at = component.requires_();
    const auto [services, name] = RTT::internal::splitAtLastDot(path);
    for (const std::string& part : RTT::internal::partsOf(services)) {
        if (!at->requiresService(part)) return nullptr;
        at = at->requires_(part);
    }
    return at->getOperationCaller(name);
}
RTT::OperationInterfacePart* findProvided(RTT::TaskContext& component, const std::string& path) {
    RTT::Service::shared_ptr at = component.provides();
    const auto [services, name] = RTT::internal::splitAtLastDot(path);
    for (const std::string& part : RTT::internal::partsOf(services)) {
        if (!at->hasService(part)) return nullptr;
        at = at->getService(part);
    }
    return at->getPart(name);
}

}  // namespace

class ROSServiceService : public RTT::Service {
public:
    explicit ROSServiceService(RTT::TaskContext* owner) : RTT::Service("rosservice", owner) {
        doc("Connects operations of this component with services of ROS.");
        addOperation("connect", &ROSServiceService::connect, this)
            .doc("Offers an operation as a service, or puts a service behind a required operation. False if that fails.")
            .arg("operation_name", "operation caller or operation, such as planner.plan")
            .arg("service_name", "name in ROS; ~x is private to the node")
            .arg("service_type", "such as std_srvs/Empty");
        addOperation("disconnect", &ROSServiceService::disconnect, this)
            .doc("Ends the connections of this component with a service. False if there are none.")
            .arg("service_name", "as in connect()");
        addOperation("disconnectAll", &ROSServiceService::disconnectAll, this)
            .doc("Ends all connections of this component with services.");
        addProperty("timeout", timeout_)
            .doc("How long the callers of connections that are made from now on wait for a response; 0: for ever. [s]");
    }
    ~ROSServiceService() override { disconnectAll(); }

private:
    struct Connected {
        std::string service, resolved, operation;
        bool isClient;
        std::unique_ptr<ROSServiceProxyBase> proxy;
    };
    typedef std::list<Connected> List;

    bool connect(const std::string& operation_name, const std::string& service_name, const std::string& service_type) {
        const RTT::Logger::In in("rosservice");
        RTT::TaskContext* const owner = getOwner();
        if (!owner) return refuse(operation_name, service_name, "the service rosservice belongs to no component");
        auto* const caller = findCaller(*owner, operation_name);
        auto* const operation = caller ? nullptr : findProvided(*owner, operation_name);
        if (!caller && !operation)
            return refuse(operation_name, service_name,
                          "component '" + owner->getName() + "' neither requires nor provides such an operation");
        ROSServiceProxyFactoryBase* const factory =
            ROSServiceRegistryService::Instance()->getServiceFactory(service_type);
        if (!factory) return refuse(operation_name, service_name, "its type is unknown");
        Connected made{service_name, "", operation_name, caller != nullptr, nullptr};
        std::string why;
        if (!resolveService(service_name, made.resolved, why)) return refuse(operation_name, service_name, why);
        try {
            made.proxy = caller ? use(*factory, service_name, *caller) : offer(*factory, service_name, *operation);
        } catch (const std::exception& error) {
            return refuse(operation_name, service_name, error.what());
        }
        if (!made.proxy) return false;
        // The caller left the service that it used before.
        const List replaced = take([&](const Connected& one) { return caller && one.isClient && one.operation == operation_name; });
        const std::lock_guard<std::mutex> lock(mutex_);
        connected_.push_back(std::move(made));
        return true;
    }
    typedef std::unique_ptr<ROSServiceProxyBase> Proxy;
    /** Null, with an error logged, if that is impossible. */
    Proxy use(ROSServiceProxyFactoryBase& factory, const std::string& service,
              RTT::base::OperationCallerBaseInvoker& caller) {
        std::unique_ptr<ROSServiceClientProxyBase> proxy(factory.create_client_proxy(service));
        if (!proxy) throw std::runtime_error("the factory of its type makes no clients");
        proxy->setTimeout(timeout_);
        return proxy->connect(getOwner(), &caller) ? Proxy(std::move(proxy)) : nullptr;
    }
    Proxy offer(ROSServiceProxyFactoryBase& factory, const std::string& service,
                RTT::OperationInterfacePart& operation) {
        std::unique_ptr<ROSServiceServerProxyBase> proxy(factory.create_server_proxy(service));
        if (!proxy) throw std::runtime_error("the factory of its type makes no servers");
        return proxy->connect(getOwner(), &operation) ? Proxy(std::move(proxy)) : nullptr;
    }
    bool disconnect(const std::string& service_name) {
        std::string resolved, why;
        if (!resolveService(service_name, resolved, why)) resolved = service_name;
        return !take([&](const Connected& one) {
                    return one.service == service_name || one.resolved == resolved;
                }).empty();
    }
    void disconnectAll() {
        (void)take([](const Connected&) { return true; });
    }

    /** Those that are taken end outside of the lock, because that asks the master. */
    template <class Chosen>
    List take(Chosen chosen) {
        List taken;
        const std::lock_guard<std::mutex> lock(mutex_);
        for (auto at = connected_.begin(); at != connected_.end();) {
            const auto one = at++;
            if (chosen(*one)) taken.splice(taken.end(), connected_, one);
        }
        return taken;
    }
    static bool refuse(const std::string& operation, const std::string& service, const std::string& why) {
        RTT::log(RTT::Error) << "operation '" << operation << "' cannot be connected with service '" << service
                             << "': " << why << RTT::endlog();
        return false;
    }

    double timeout_ = 0;
    std::mutex mutex_;
    List connected_;
};

}  // namespace rtt_roscomm

ORO_SERVICE_NAMED_PLUGIN(rtt_roscomm::ROSServiceService, "rosservice")
