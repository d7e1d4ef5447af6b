// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "MarshallingService.hpp"

#include "PropertyLoader.hpp"

#include <rtt/Logger.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

namespace RTT {
namespace marsh {

MarshallingService::MarshallingService(TaskContext* parent) : Service("marshalling", parent) {
    doc("Reads and writes property files");
    addWholeOperations();
    addServiceOperations();
}

void MarshallingService::addWholeOperations() {
    using S = MarshallingService;
    addOperation("loadProperties", &S::loadProperties, this)
        .doc("Takes over what the file has, creating missing properties")
        .arg("Filename", "path of the property file");
    addOperation("storeProperties", &S::storeProperties, this)
        .doc("Writes all properties to a new file")
        .arg("Filename", "path of the property file");
    addOperation("readProperties", &S::readProperties, this)
        .doc("Takes over the file, which must have every property")
        .arg("Filename", "path of the property file");
    addOperation("updateProperties", &S::updateProperties, this)
        .doc("Takes over what file and component both have")
        .arg("Filename", "path of the property file");
    addOperation("writeProperties", &S::writeProperties, this)
        .doc("Adds and updates all properties in the file")
        .arg("Filename", "path of the property file");
    addOperation("updateFile", &S::updateFile, this)
        .doc("Updates what the file has already")
        .arg("Filename", "path of the property file");
    addOperation("readProperty", &S::readProperty, this)
        .doc("Takes over one property")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file");
    addOperation("writeProperty", &S::writeProperty, this)
        .doc("Adds or updates one property in the file")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file");
}

void MarshallingService::addServiceOperations() {
    using S = MarshallingService;
    addOperation("loadServiceProperties", &S::loadServiceProperties, this)
        .doc("Takes over what the file has, creating missing properties; for a service")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("storeServiceProperties", &S::storeServiceProperties, this)
        .doc("Writes all properties to a new file; for a service")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("readServiceProperties", &S::readServiceProperties, this)
        .doc("Takes over the file, which must have every property; for a service")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("updateServiceProperties", &S::updateServiceProperties, this)
        .doc("Takes over what file and component both have; for a service")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("writeServiceProperties", &S::writeServiceProperties, this)
        .doc("Adds and updates all properties in the file; for a service")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("updateServiceFile", &S::updateServiceFile, this)
        .doc("Updates what the file has already; for a service")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("readServiceProperty", &S::readServiceProperty, this)
        .doc("Takes over one property; for a service")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("writeServiceProperty", &S::writeServiceProperty, this)
        .doc("Adds or updates one property in the file; for a service")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
}

Service* MarshallingService::target() {
    const Service::shared_ptr parent = getParent();
    return parent ? parent.get() : getOwner() ? getOwner()->provides().get() : nullptr;
}

Service* MarshallingService::target(const std::string& servicename) {
    Service* parent = target();
    if (parent && parent->hasService(servicename)) return parent->getService(servicename).get();
    log(Error) << (parent ? parent->getName() : getName()) << " has no service called " << servicename << endlog();
    return nullptr;
}

bool MarshallingService::loadProperties(const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).load(filename);
}

bool MarshallingService::storeProperties(const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).store(filename);
}

bool MarshallingService::readProperties(const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).configure(filename, true);
}

bool MarshallingService::updateProperties(const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).configure(filename, false);
}

bool MarshallingService::writeProperties(const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).save(filename, true);
}

bool MarshallingService::updateFile(const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).save(filename, false);
}

bool MarshallingService::readProperty(const std::string& name, const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).configure(filename, name);
}

bool MarshallingService::writeProperty(const std::string& name, const std::string& filename) {
    Service* service = target();
    return service && PropertyLoader(service).save(filename, name);
}

bool MarshallingService::loadServiceProperties(const std::string& filename, const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).load(filename);
}

bool MarshallingService::storeServiceProperties(const std::string& filename, const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).store(filename);
}

bool MarshallingService::readServiceProperties(const std::string& filename, const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).configure(filename, true);
}

bool MarshallingService::updateServiceProperties(const std::string& filename, const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).configure(filename, false);
}

bool MarshallingService::writeServiceProperties(const std::string& filename, const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).save(filename, true);
}

bool MarshallingService::updateServiceFile(const std::string& filename, const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).save(filename, false);
}

bool MarshallingService::readServiceProperty(const std::string& name, const std::string& filename,
                                             const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).configure(filename, name);
}

bool MarshallingService::writeServiceProperty(const std::string& name, const std::string& filename,
                                              const std::string& servicename) {
    Service* service = target(servicename);
    return service && PropertyLoader(service).save(filename, name);
}

}  // namespace marsh
}  // namespace RTT

ORO_SERVICE_NAMED_PLUGIN(RTT::marsh::MarshallingService, "marshalling")
