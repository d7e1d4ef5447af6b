// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_parameters.hpp"

#include "fill_value.hpp"
#include "master.hpp"
#include "names.hpp"
#include "read_value.hpp"
#include "xml_value.hpp"

#include <rtt/Logger.hpp>
#include <rtt_ros/guarded.hpp>

#include <optional>

namespace rtt_rosparam {

using namespace RTT;
using rtt_ros::problemIn;
typedef XmlRpc::XmlRpcValue Value;

namespace {

bool report(LoggerLevel level, const std::string& problem) {
    if (!problem.empty()) log(level) << problem << endlog();
    return problem.empty();
}

/** Not set: a line for those who look for it. */
std::optional<Value> fetch(const std::string& name) {
    Value value;
    bool isSet = false;
    const bool isRead = report(Error, problemIn([&] {
                                   const std::string full = resolved(name);
                                   isSet = master::get(full, value);
                                   if (!isSet) log(Info) << "parameter '" << full << "' is not set" << endlog();
                               }));
    return isRead && isSet ? std::optional<Value>(value) : std::nullopt;
}

std::string below(const std::string& name, const std::string& item) {
    return name.empty() || name == "/" ? name + item : name + '/' + item;
}

bool fillProperty(base::PropertyBase& property, const std::string& name, const Value& value) {
    return report(Warning, problemIn([&] {
                      Filler filler(name);
                      filler.prepare(property, value);
                      filler.commit();
                  }));
}

/** Calls each(name, service) for the services in this one. */
template <class Each>
void forServices(Service& service, Each each) {
    for (const std::string& name : service.getProviderNames()) {
        const Service::shared_ptr inner = service.getService(name);
        if (inner && inner.get() != &service) each(name, *inner);
    }
}

bool fillService(Service& service, const std::string& name, const Value& values) {
    if (values.getType() != Value::TypeStruct)
        return report(Warning, "parameter '" + name + "' is " + described(values) +
                                   ", which cannot set the properties of service '" + service.getName() + "'");
    bool isGood = true;
    for (base::PropertyBase* const property : *service.properties())
        if (property->ready() && values.hasMember(property->getName()))
            isGood = fillProperty(*property, below(name, property->getName()), values[property->getName()]) && isGood;
    forServices(service, [&](const std::string& inner, Service& its) {
        if (!values.hasMember(inner) || service.properties()->find(inner)) return;
        (void)fillService(its, below(name, inner), values[inner]);
    });
    return isGood;
}

bool readProperty(const base::PropertyBase& property, const std::string& name, master::Parameters& made) {
    return report(Warning, problemIn([&] { made.emplace_back(name, Reader(name).read(property)); }));
}

bool readService(Service& service, const std::string& name, master::Parameters& made) {
    bool isGood = true;
    for (const base::PropertyBase* const property : *service.properties()) {
        if (!property->ready()) continue;
        const bool isNamed = isParameterName(property->getName());
        isGood = (isNamed ? readProperty(*property, below(name, property->getName()), made)
                          : report(Warning, "'" + property->getName() + "' cannot be the name of a parameter in '" +
                                                name + "'; rename the property")) &&
                 isGood;
    }
    forServices(service, [&](const std::string& inner, Service& its) {
        if (service.properties()->find(inner)) return;
        isGood = readService(its, below(name, inner), made) && isGood;
    });
    return isGood;
}

bool store(const master::Parameters& parameters) {
    return report(Error, problemIn([&] { master::set(parameters); }));
}

/** "" if that cannot be, which is logged. */
std::string full(const std::string& name) {
    std::string made;
    report(Error, problemIn([&] { made = resolved(name); }));
    return made;
}

bool missing(const Service& service, const std::string& item) {
    return report(Warning,
                  "service '" + service.getName() + "' has no property and no service of the name '" + item + "'");
}

}  // namespace

bool ServiceParameters::getAll(const std::string& name) {
    const Logger::In in("rosparam");
    const auto values = fetch(name);
    return values && fillService(service_, full(name), *values);
}

bool ServiceParameters::setAll(const std::string& name) {
    const Logger::In in("rosparam");
    const std::string root = full(name);
    if (root.empty()) return false;
    master::Parameters made;
    const bool isGood = readService(service_, root, made);
    return store(made) && isGood;
}

bool ServiceParameters::getItem(const std::string& name, const std::string& item) {
    const Logger::In in("rosparam");
    base::PropertyBase* const property = service_.properties()->find(item);
    const Service::shared_ptr inner = property ? nullptr : service_.getService(item);
    if (!property && !inner) return missing(service_, item);
    const auto value = fetch(name);
    if (!value) return false;
    return property ? fillProperty(*property, full(name), *value) : fillService(*inner, full(name), *value);
}

bool ServiceParameters::setItem(const std::string& name, const std::string& item) {
    const Logger::In in("rosparam");
    const base::PropertyBase* const property = service_.properties()->find(item);
    const Service::shared_ptr inner = property ? nullptr : service_.getService(item);
    if (!property && !inner) return missing(service_, item);
    const std::string root = full(name);
    if (root.empty()) return false;
    master::Parameters made;
    const bool isGood = property ? readProperty(*property, root, made) : readService(*inner, root, made);
    return (made.empty() || store(made)) && isGood;
}

bool readParameter(const std::string& name, const std::type_info& type, void* value) {
    const Logger::In in("rosparam");
    const auto found = fetch(name);
    return found && report(Warning, problemIn([&] { Filler(full(name)).fill(type.name(), *found, value); }));
}

bool writeParameter(const std::string& name, const std::type_info& type, const void* value) {
    const Logger::In in("rosparam");
    return report(Error, problemIn([&] {
                      const std::string root = resolved(name);
                      master::set({{root, Reader(root).read(type.name(), value)}});
                  }));
}

}  // namespace rtt_rosparam
