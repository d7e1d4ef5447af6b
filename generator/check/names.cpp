// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

#include <algorithm>
#include <cctype>
#include <set>

#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>

namespace oroforge::check {

namespace {

/// Members of RTT::TaskContext: an operation with such a name would hide or override them.
bool isTaskContextMember(const std::string& name) {
    static const std::set<std::string> members = {
        "activate",       "addAttribute",   "addConstant",     "addEventPort", "addLocalPort",
        "addOperation",   "addPeer",        "addPort",         "addProperty",  "attributes",
        "cleanup",        "cleanupHook",    "clear",           "configure",    "configureHook",
        "connectPeers",   "connectPorts",   "connectServices", "dataOnPort",   "dataOnPortCallback",
        "dataOnPortHook", "disconnect",     "disconnectPeers", "engine",       "error",
        "errorHook",      "exception",      "exceptionHook",   "fatal",        "forceActivity",
        "getActivity",    "getAttribute",   "getCpuAffinity",  "getName",      "getOperation",
        "getPeer",        "getPeerList",    "getPeriod",       "getPort",      "getProperty",
        "getProvider",    "getTargetState", "getTaskState",    "hasPeer",      "inException",
        "inFatalError",   "inRunTimeError", "isActive",        "isConfigured", "isRunning",
        "loadService",    "operations",     "ports",           "properties",   "provides",
        "ready",          "recover",        "removePeer",      "requires",     "resetException",
        "setActivity",    "setCpuAffinity", "setPeriod",       "start",        "startHook",
        "stop",           "stopForGood",    "stopHook",        "trigger",      "update",
        "updateHook"};
    return members.count(name) != 0;
}

/// Attributes that every component has.
bool isStandardAttribute(const std::string& name) {
    static const std::set<std::string> attributes = {"TriggerOnStart", "CycleCounter", "IOCounter", "TimeOutCounter",
                                                     "TriggerCounter"};
    return attributes.count(name) != 0;
}

bool checkIdentifier(const std::string& what, const model::Text& name, diag::Sink& sink) {
    if (!name.given()) return false;
    if (!model::isIdentifier(name.value)) {
        sink.error(name.where, "OM010",
                   what + " name '" + name.value +
                       "' is not an identifier: expected letters, digits and '_', not a digit first");
        return false;
    }
    if (model::isKeyword(name.value)) {
        sink.error(name.where, "OM011", what + " name '" + name.value + "' is a C++ keyword");
        return false;
    }
    return true;
}

/// Members of RTT::Service that RTT::TaskContext does not have.
bool isServiceMember(const std::string& name) {
    static const std::set<std::string> members = {"doc",        "getOwner",     "getParent",           "getNames",
                                                  "hasService", "hasOperation", "getOperationFactory", "removeService",
                                                  "setOwner",   "setName"};
    return members.count(name) != 0 || isTaskContextMember(name);
}

enum class Owner { Component, ServicePlugin, ProvidedService };

void checkMember(const std::string& what, const model::Text& name, Owner owner, diag::Sink& sink) {
    if (!checkIdentifier(what, name, sink)) return;
    const bool inComponent = isTaskContextMember(name.value) || isStandardAttribute(name.value);
    if (owner == Owner::Component && inComponent) {
        sink.error(name.where, "OM015", what + " name '" + name.value + "' is taken: every component already has it");
    } else if (owner == Owner::ServicePlugin && isServiceMember(name.value)) {
        sink.error(name.where, "OM015", what + " name '" + name.value + "' is taken: every service already has it");
    }
}

void checkOperation(const model::Operation& operation, Owner owner, diag::Sink& sink) {
    checkMember("operation", operation.name, owner, sink);
    for (const auto& argument : operation.arguments) checkIdentifier("argument", argument.name, sink);
}

/// `top` belongs to a component or a service; services below it have names of their own.
void checkInterface(const model::Interface& top, Owner ownerOfTop, diag::Sink& sink) {
    model::eachInterface(top, [&](const model::Interface& interface, const model::ServicePath& path) {
        const Owner owner = path.empty() ? ownerOfTop : Owner::ProvidedService;
        for (const auto& port : interface.ports) checkMember("port", port.name, owner, sink);
        for (const auto& property : interface.properties) checkMember("property", property.name, owner, sink);
        for (const auto& attribute : interface.attributes) checkMember("attribute", attribute.name, owner, sink);
        for (const auto& operation : interface.operations) checkOperation(operation, owner, sink);
        for (const auto& service : interface.services) checkIdentifier("service", service.name, sink);
    });
}

void checkClassName(const model::Text& name, diag::Sink& sink) {
    if (!name.given()) return;
    for (const std::string& part : model::splitQualified(name.value)) {
        if (model::isIdentifier(part) && !model::isKeyword(part)) continue;
        sink.error(name.where, "OM014",
                   "'" + name.value +
                       "' is not a class name: expected identifiers joined by '::', such as 'tank::Controller'");
        return;
    }
}

void checkComponent(const model::Component& component, diag::Sink& sink) {
    checkClassName(component.className, sink);
    checkInterface(component, Owner::Component, sink);
    for (const auto& required : component.required) {
        // "this" is the component's own requester, for operations that no service of the peer provides.
        if (required.name.value != "this") checkIdentifier("service", required.name, sink);
        for (const auto& operation : required.operations) checkOperation(operation, Owner::ProvidedService, sink);
    }
}

void checkServicePlugin(const model::ServicePlugin& service, diag::Sink& sink) {
    checkClassName(service.className, sink);
    checkIdentifier("service", service.name, sink);
    checkInterface(service, Owner::ServicePlugin, sink);
}

void checkFileName(const std::string& what, const model::Text& name, diag::Sink& sink) {
    const std::string fault = packageNameFault(name.value);
    if (name.given() && !fault.empty()) sink.error(name.where, "OM013", what + " name '" + name.value + "' " + fault);
}

bool isVersion(const std::string& text) {
    std::size_t parts = 1;
    bool digit = false;
    for (const char c : text) {
        if (c == '.' && digit) {
            ++parts;
            digit = false;
        } else if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
            digit = true;
        } else {
            return false;
        }
    }
    return digit && parts == 3;
}

void checkHeader(const model::Text& header, diag::Sink& sink) {
    if (!header.given()) return;
    const bool relative =
        !header.value.empty() && header.value[0] != '/' && header.value.find("..") == std::string::npos;
    const bool plain = header.value.find_first_of(" \t\"<>\\;$") == std::string::npos;
    if (relative && plain) return;
    sink.error(header.where, "OM017",
               "'" + header.value +
                   "' is not a header of this package: expected a path such as 'include/tank/tank-types.hpp'");
}

}  // namespace

std::string packageNameFault(const std::string& name) {
    if (name.empty()) return "is empty";
    if (std::isalpha(static_cast<unsigned char>(name.front())) == 0) return "does not begin with a letter";
    const auto bad = std::find_if(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) == 0 && c != '_' && c != '.' && c != '-';
    });
    if (bad != name.end()) {
        return std::string("contains '") + *bad + "'; expected letters, digits, '_', '.' and '-'";
    }
    // The package's name becomes a namespace and a build target.
    if (model::isKeyword(name)) return "is a C++ keyword";
    static const std::set<std::string> targets = {"all", "clean", "help", "install", "package", "test", "uninstall"};
    if (targets.count(name) != 0) return "is a target of every build";
    return {};
}

void names(const model::Package& package, diag::Sink& sink) {
    if (package.name.given()) {
        const std::string fault = packageNameFault(package.name.value);
        if (!fault.empty())
            sink.error(package.name.where, "OM013", "package name '" + package.name.value + "' " + fault);
    }
    if (package.version.given() && !isVersion(package.version.value)) {
        sink.error(package.version.where, "OM016",
                   "version '" + package.version.value + "' is not of the form '1.2.3'");
    }
    for (const auto& dependency : package.dependencies) checkFileName("package", dependency, sink);
    for (const auto& plugin : package.plugins) checkFileName("plugin", plugin.name, sink);
    for (const auto& header : package.typekitHeaders) checkHeader(header, sink);
    for (const auto& component : package.components) checkComponent(component, sink);
    for (const auto& service : package.services) checkServicePlugin(service, sink);
}

}  // namespace oroforge::check
