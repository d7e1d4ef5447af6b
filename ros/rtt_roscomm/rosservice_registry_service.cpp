// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt_roscomm/message_table.hpp>
#include <rtt_roscomm/rtt_rosservice_registry_service.h>

#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace rtt_roscomm {

namespace {

const char* const kName = "rosservice_registry";

ServiceType typeOf(const ServiceEntry& entry) { return {entry.service, entry.md5}; }

/** Null, with the reason, if a type is missing. */
Form standardFormOf(const ServiceEntry& entry, std::string& why) {
    Codec request = registeredCodec(entry.request, why);
    Codec response = request ? registeredCodec(entry.response, why) : nullptr;
    return response ? standardForm(std::move(request), std::move(response)) : nullptr;
}

std::string hint(const ServiceEntry& entry, const std::string& why) { return why + "; " + importOf(entry.service); }

class TableServerProxy final : public ROSServiceServerProxyBase {
public:
    TableServerProxy(const ServiceEntry& entry, const std::string& name)
        : ROSServiceServerProxyBase(name), entry_(entry) {}

    bool connect(RTT::TaskContext* owner, RTT::OperationInterfacePart* operation) override {
        if (!operation) return false;
        std::string why;
        std::vector<Form> forms = shortForms(entry_.service);
        const Form standard = standardFormOf(entry_, why);
        if (standard) forms.insert(forms.begin(), standard);
        const RTT::internal::OperationSignature signature = operation->signature();
        std::vector<std::string> wanted;
        for (const Form& form : forms) {
            if (fits(signature, *form)) return offer(owner, *operation, form);
            wanted.push_back(form->text());
        }
        if (!standard)
            wanted.push_back(std::string("bool(") + entry_.request + " const&, " + entry_.response + " &) (" +
                             hint(entry_, why) + ")");
        return refuse(typeOf(entry_), owner, *operation, wanted);
    }

private:
    bool offer(RTT::TaskContext* owner, const RTT::OperationInterfacePart& operation, const Form& form) {
        const std::string what = describe(owner, operation);
        try {
            return advertise(typeOf(entry_), answerByOperation(operation, form, what));
        } catch (const std::exception& error) {
            RTT::log(RTT::Error) << what << " cannot be service '" << getServiceName() << "': " << error.what()
                                 << RTT::endlog();
            return false;
        }
    }
    const ServiceEntry& entry_;
};

class TableClientProxy final : public ROSServiceClientProxyBase {
public:
    TableClientProxy(const ServiceEntry& entry, const std::string& name)
        : ROSServiceClientProxyBase(name), entry_(entry) {}

    bool connect(RTT::TaskContext* owner, RTT::base::OperationCallerBaseInvoker* caller) override {
        if (!caller) return false;
        std::string why;
        Form form = shortFormOfCaller(entry_.service, typeid(*caller));
        if (!form) form = standardFormOf(entry_, why);
        if (form) return bind(typeOf(entry_), std::move(form), owner, *caller);
        RTT::log(RTT::Error) << "operation caller '" << caller->getName() << "' cannot use service '"
                             << getServiceName() << "': " << hint(entry_, why) << RTT::endlog();
        return false;
    }

private:
    const ServiceEntry& entry_;
};

class TableFactory final : public ROSServiceProxyFactoryBase {
public:
    explicit TableFactory(const ServiceEntry& entry) : ROSServiceProxyFactoryBase(entry.service), entry_(entry) {}
    ROSServiceClientProxyBase* create_client_proxy(const std::string& name) override {
        return new TableClientProxy(entry_, name);
    }
    ROSServiceServerProxyBase* create_server_proxy(const std::string& name) override {
        return new TableServerProxy(entry_, name);
    }

private:
    const ServiceEntry& entry_;
};

struct Registry {
    typedef std::unique_ptr<ROSServiceProxyFactoryBase> Factory;
    std::mutex mutex;
    std::map<std::string, Factory> ofUsers, ofTables;
    std::vector<Factory> replaced;

    ROSServiceProxyFactoryBase* find(const std::string& type) {
        const std::lock_guard<std::mutex> lock(mutex);
        for (const auto* known : {&ofUsers, &ofTables})
            if (const auto at = known->find(type); at != known->end()) return at->second.get();
        return nullptr;
    }
};

/** Never destroyed: components may use factories while the process ends. */
Registry& registry() {
    static auto* const instance = new Registry();
    return *instance;
}

}  // namespace

void addServices(const ServiceEntry* first, std::size_t count) {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    for (const ServiceEntry* entry = first; entry != first + count; ++entry)
        registry().ofTables.emplace(entry->service, std::make_unique<TableFactory>(*entry));
}

ROSServiceRegistryService::shared_ptr ROSServiceRegistryService::Instance() {
    static std::mutex one;
    const std::lock_guard<std::mutex> lock(one);
    const RTT::Service::shared_ptr global = RTT::internal::GlobalService::Instance();
    if (!global->hasService(kName)) (void)global->addService(RTT::Service::shared_ptr(new ROSServiceRegistryService()));
    return boost::dynamic_pointer_cast<ROSServiceRegistryService>(global->getService(kName));
}

ROSServiceRegistryService::ROSServiceRegistryService(RTT::TaskContext* owner) : RTT::Service(kName, owner) {
    doc("The types of services of ROS that this process knows.");
    addOperation("registerServiceFactory", &ROSServiceRegistryService::registerServiceFactory, this)
        .doc("Makes a type of services known, or replaces what connects it. False for null.")
        .arg("factory", "what makes connections; owned by the registry from now on");
    addOperation("hasServiceFactory", &ROSServiceRegistryService::hasServiceFactory, this)
        .doc("Is a type of services known?")
        .arg("service_type", "such as std_srvs/Empty");
    addOperation("getServiceFactory", &ROSServiceRegistryService::getServiceFactory, this)
        .doc("What connects a type of services, for C++; null if the type is unknown.")
        .arg("service_type", "such as std_srvs/Empty");
    addOperation("listSrvs", &ROSServiceRegistryService::listSrvs, this)
        .doc("All types of services that are known, in alphabetical order.");
}

bool ROSServiceRegistryService::registerServiceFactory(ROSServiceProxyFactoryBase* factory) {
    if (!factory) {
        RTT::log(RTT::Error) << kName << ": a null pointer is no factory of services" << RTT::endlog();
        return false;
    }
    const std::lock_guard<std::mutex> lock(registry().mutex);
    Registry::Factory& place = registry().ofUsers[factory->getType()];
    if (place.get() == factory) return true;
    if (place) registry().replaced.push_back(std::move(place));
    place.reset(factory);
    return true;
}

bool ROSServiceRegistryService::hasServiceFactory(const std::string& service_type) {
    return registry().find(service_type) != nullptr;
}

ROSServiceProxyFactoryBase* ROSServiceRegistryService::getServiceFactory(const std::string& service_type) {
    ROSServiceProxyFactoryBase* const found = registry().find(service_type);
    if (!found)
        RTT::log(RTT::Error) << "service type '" << service_type << "' is unknown; "
                             << (service_type.find('/') == std::string::npos
                                     ? "write it with its package, as std_srvs/Empty"
                                     : importOf(service_type) + ", or make that package, with its services")
                             << RTT::endlog();
    return found;
}

std::vector<std::string> ROSServiceRegistryService::listSrvs() {
    std::vector<std::string> names;
    {
        const std::lock_guard<std::mutex> lock(registry().mutex);
        std::map<std::string, int> all;
        for (const auto* known : {&registry().ofUsers, &registry().ofTables})
            for (const auto& one : *known) all[one.first];
        for (const auto& one : all) names.push_back(one.first);
    }
    RTT::Logger::In in(kName);
    for (const std::string& name : names) RTT::log(RTT::Info) << name << RTT::endlog();
    return names;
}

}  // namespace rtt_roscomm
