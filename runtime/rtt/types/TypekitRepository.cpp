// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "TypekitRepository.hpp"

#include <rtt/Logger.hpp>
#include "TransportPlugin.hpp"
#include "TypeInfoRepository.hpp"
#include "TypekitPlugin.hpp"
#include <map>
#include <memory>
#include <mutex>

namespace RTT::types {

namespace {

/** Never destroyed: types refer to objects that their typekits made. */
struct Loaded {
    std::mutex mutex;
    std::map<std::string, TypekitPlugin*> typekits;
    std::map<std::string, TransportPlugin*> transports;
};

Loaded& loaded() {
    static auto* instance = new Loaded();
    return *instance;
}

bool load(TypekitPlugin& typekit) {
    if (typekit.loadTypes() && typekit.loadConstructors() && typekit.loadOperators() && typekit.loadGlobals())
        return true;
    log(Error) << "typekit " << typekit.getName() << " reports that it could not be loaded completely" << endlog();
    return false;
}

/** False if there is one of that name already. */
template <class Plugin>
bool remember(std::map<std::string, Plugin*>& known, const std::string& name, Plugin* plugin) {
    std::lock_guard<std::mutex> lock(loaded().mutex);
    return known.emplace(name, plugin).second;
}

}  // namespace

bool TypekitRepository::Import(TypekitPlugin* typekit) {
    std::unique_ptr<TypekitPlugin> owned(typekit);
    if (!typekit) return false;
    const std::string name = typekit->getName();
    if (!remember(loaded().typekits, name, typekit)) {
        log(Info) << "typekit " << name << " is loaded already" << endlog();
        return true;
    }
    return load(*owned.release());
}

bool TypekitRepository::Import(TypekitPlugin& typekit) {
    if (remember(loaded().typekits, typekit.getName(), &typekit)) return load(typekit);
    log(Info) << "typekit " << typekit.getName() << " is loaded already" << endlog();
    return true;
}

bool TypekitRepository::Import(TransportPlugin* transport) {
    std::unique_ptr<TransportPlugin> owned(transport);
    if (!transport) return false;
    if (!remember(loaded().transports, transport->getName(), transport)) {
        log(Info) << "transport " << transport->getName() << " is loaded already" << endlog();
        return true;
    }
    Types()->registerTransport(owned.release());
    return true;
}

bool TypekitRepository::hasTypekit(const std::string& name) {
    std::lock_guard<std::mutex> lock(loaded().mutex);
    return loaded().typekits.count(name) != 0;
}

bool TypekitRepository::hasTransport(const std::string& name) {
    std::lock_guard<std::mutex> lock(loaded().mutex);
    return loaded().transports.count(name) != 0;
}

}  // namespace RTT::types
