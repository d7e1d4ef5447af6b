// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "MarshallingService.hpp"

#include "PropertyLoader.hpp"

#include <rtt/internal/calls/failed.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

namespace RTT::marsh {

MarshallingService::MarshallingService(TaskContext* parent) : Service("marshalling", parent) {
    doc("Reads and writes property files.");
    addWholeOperations();
    addServiceOperations();
    internal::FailureReport::add(*this);
}

MarshallingService::~MarshallingService() { internal::FailureReport::remove(*this); }

void MarshallingService::addWholeOperations() {
    using S = MarshallingService;
    addOperation("loadProperties", &S::loadProperties, this)
        .doc("Reads all that the file has, and creates missing properties.")
        .arg("Filename", "path of the property file");
    addOperation("storeProperties", &S::storeProperties, this)
        .doc("Writes all properties to a new file.")
        .arg("Filename", "path of the property file");
    addOperation("readProperties", &S::readProperties, this)
        .doc("Reads the file, which must have every property.")
        .arg("Filename", "path of the property file");
    addOperation("updateProperties", &S::updateProperties, this)
        .doc("Reads what file and component both have.")
        .arg("Filename", "path of the property file");
    addOperation("writeProperties", &S::writeProperties, this)
        .doc("Adds and updates all properties in the file.")
        .arg("Filename", "path of the property file");
    addOperation("updateFile", &S::updateFile, this)
        .doc("Updates what the file has already.")
        .arg("Filename", "path of the property file");
    addOperation("readProperty", &S::readProperty, this)
        .doc("Reads one property.")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file");
    addOperation("writeProperty", &S::writeProperty, this)
        .doc("Adds or updates one property in the file.")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file");
}

void MarshallingService::addServiceOperations() {
    using S = MarshallingService;
    addOperation("loadServiceProperties", &S::loadServiceProperties, this)
        .doc("Reads all that the file has into a service, and creates missing properties.")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("storeServiceProperties", &S::storeServiceProperties, this)
        .doc("Writes all properties of a service to a new file.")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("readServiceProperties", &S::readServiceProperties, this)
        .doc("Reads the file, which must have every property, into a service.")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("updateServiceProperties", &S::updateServiceProperties, this)
        .doc("Reads what file and service both have.")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("writeServiceProperties", &S::writeServiceProperties, this)
        .doc("Adds and updates all properties of a service in the file.")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("updateServiceFile", &S::updateServiceFile, this)
        .doc("Updates what the file has already of a service.")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("readServiceProperty", &S::readServiceProperty, this)
        .doc("Reads one property of a service.")
        .arg("Name", "path of the property, as in a.b.c")
        .arg("Filename", "path of the property file")
        .arg("Servicename", "name of a service of this component");
    addOperation("writeServiceProperty", &S::writeServiceProperty, this)
        .doc("Adds or updates one property of a service in the file.")
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
    internal::failed((parent ? parent->getName() : getName()) + " has no service called " + servicename);
    return nullptr;
}

namespace {

std::string described(Service& service) {
    TaskContext* const owner = service.getOwner();
    const std::string component = owner ? "component '" + owner->getName() + "'" : "no component";
    const bool isMain = owner && owner->provides().get() == &service;
    return isMain ? component : "service '" + service.getName() + "' of " + component;
}

/** Calls `use` with a loader for that service and returns its result. The loader logs the errors of the file. If `use`
    fails, the calling script gets the reason: what could not be done (`action`), the service and `file`. */
template <class Use>
bool used(Service* service, const std::string& action, const std::string& file, Use use) {
    return service && internal::toldOr("could not " + action + " of " + described(*service) + file,
                                       [&] { return use(PropertyLoader(service)); });
}

std::string quoted(const char* word, const std::string& name) { return std::string(word) + "'" + name + "'"; }

bool load(Service* service, const std::string& file) {
    return used(service, "load the properties", quoted(" from ", file),
                [&](const PropertyLoader& loader) { return loader.load(file); });
}

bool store(Service* service, const std::string& file) {
    return used(service, "store the properties", quoted(" in ", file),
                [&](const PropertyLoader& loader) { return loader.store(file); });
}

bool read(Service* service, const std::string& file, bool all) {
    return used(service, all ? "read the properties" : "update the properties", quoted(" from ", file),
                [&](const PropertyLoader& loader) { return loader.configure(file, all); });
}

bool readOne(Service* service, const std::string& name, const std::string& file) {
    return used(service, quoted("read property ", name), quoted(" from ", file),
                [&](const PropertyLoader& loader) { return loader.configure(file, name); });
}

bool write(Service* service, const std::string& file) {
    return used(service, "write the properties", quoted(" to ", file),
                [&](const PropertyLoader& loader) { return loader.save(file, true); });
}

bool writeOne(Service* service, const std::string& name, const std::string& file) {
    return used(service, quoted("write property ", name), quoted(" to ", file),
                [&](const PropertyLoader& loader) { return loader.save(file, name); });
}

bool updateIn(Service* service, const std::string& file) {
    return used(service, quoted("update ", file) + " with the properties", "",
                [&](const PropertyLoader& loader) { return loader.save(file, false); });
}

}  // namespace

typedef const std::string& Text;

bool MarshallingService::loadProperties(Text file) { return load(target(), file); }
bool MarshallingService::storeProperties(Text file) { return store(target(), file); }
bool MarshallingService::readProperties(Text file) { return read(target(), file, true); }
bool MarshallingService::updateProperties(Text file) { return read(target(), file, false); }
bool MarshallingService::writeProperties(Text file) { return write(target(), file); }
bool MarshallingService::updateFile(Text file) { return updateIn(target(), file); }
bool MarshallingService::readProperty(Text name, Text file) { return readOne(target(), name, file); }
bool MarshallingService::writeProperty(Text name, Text file) { return writeOne(target(), name, file); }

bool MarshallingService::loadServiceProperties(Text file, Text service) { return load(target(service), file); }
bool MarshallingService::storeServiceProperties(Text file, Text service) { return store(target(service), file); }
bool MarshallingService::readServiceProperties(Text file, Text service) { return read(target(service), file, true); }
bool MarshallingService::updateServiceProperties(Text file, Text service) { return read(target(service), file, false); }
bool MarshallingService::writeServiceProperties(Text file, Text service) { return write(target(service), file); }
bool MarshallingService::updateServiceFile(Text file, Text service) { return updateIn(target(service), file); }

bool MarshallingService::readServiceProperty(Text name, Text file, Text service) {
    return readOne(target(service), name, file);
}

bool MarshallingService::writeServiceProperty(Text name, Text file, Text service) {
    return writeOne(target(service), name, file);
}

}  // namespace RTT::marsh

ORO_SERVICE_NAMED_PLUGIN(RTT::marsh::MarshallingService, "marshalling")
