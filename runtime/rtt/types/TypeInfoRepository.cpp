// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "TypeInfoRepository.hpp"

#include <rtt/Logger.hpp>
#include "TransportPlugin.hpp"
#include "TypeInfo.hpp"
#include "TypeInfoGenerator.hpp"
#include <rtt/types/detail/type_names.hpp>
#include <algorithm>
#include <map>
#include <mutex>
#include <string_view>
#include <unordered_map>

namespace RTT::types {

/**
 * Types are never removed: pointers handed out stay valid, which the caches in DataSourceTypeInfo rely on.
 * The mutex guards the maps; generators, transports and the auto-loader run without it.
 */
struct TypeInfoRepository::State {
    mutable std::mutex mutex;
    std::map<std::string, TypeInfo*> byName;               // first names and aliases
    std::unordered_map<std::string_view, TypeInfo*> byId;  // type_info::name()
    std::unordered_map<std::string_view, TypeInfo*> byArrayElement;
    std::vector<std::unique_ptr<TypeInfo>> types;
    std::vector<TransportPlugin*> transports;
    boost::function<bool(const std::string&)> autoLoader;
    TypeInfo unknown{"unknown_t", &typeid(internal::UnknownType)};

    /** Logs an error and returns false if the name belongs to another type than `info`. */
    bool isFree(const std::string& name, const TypeInfo* info) const {
        const TypeInfo* known = find(name);
        if (!known || known == info) return true;
        log(Error) << "refusing type " << name << ": the name belongs to another type already, C++ type "
                   << known->getTypeIdName() << endlog();
        return false;
    }
    TypeInfo* find(const std::string& name) const {
        std::lock_guard<std::mutex> lock(mutex);
        auto it = byName.find(name);
        if (it == byName.end()) it = byName.find(detail::slashedName(name));
        return it == byName.end() ? nullptr : it->second;
    }
};

TypeInfoRepository::TypeInfoRepository() : state_(new State) {}

TypeInfoRepository::~TypeInfoRepository() = default;

TypeInfoRepository::shared_ptr TypeInfoRepository::Instance() {
    // Never destroyed: plugins are not unloaded before it, and sources in static objects may still ask for types.
    static auto* instance = new shared_ptr(new TypeInfoRepository());
    return *instance;
}

TypeInfoRepository::shared_ptr Types() { return TypeInfoRepository::Instance(); }

TypeInfo* TypeInfoRepository::type(const std::string& name) const {
    if (TypeInfo* found = state_->find(name)) return found;
    boost::function<bool(const std::string&)> loader;
    {
        std::lock_guard<std::mutex> lock(state_->mutex);
        loader = state_->autoLoader;
    }
    return loader && loader(name) ? state_->find(name) : nullptr;
}

TypeInfo* TypeInfoRepository::getTypeById(const std::type_info* id) const {
    return id ? getTypeById(id->name()) : nullptr;
}

TypeInfo* TypeInfoRepository::getTypeById(const char* idName) const {
    std::lock_guard<std::mutex> lock(state_->mutex);
    const auto it = state_->byId.find(idName);
    return it == state_->byId.end() ? nullptr : it->second;
}

TypeInfo* TypeInfoRepository::getArrayType(const char* elementIdName) const {
    std::lock_guard<std::mutex> lock(state_->mutex);
    const auto it = state_->byArrayElement.find(elementIdName);
    return it == state_->byArrayElement.end() ? nullptr : it->second;
}

TypeInfo* TypeInfoRepository::unknownType() const { return &state_->unknown; }

std::vector<std::string> TypeInfoRepository::getTypes() const {
    std::lock_guard<std::mutex> lock(state_->mutex);
    std::vector<std::string> names;
    for (const auto& entry : state_->byName) names.push_back(entry.first);
    return names;
}

std::vector<std::string> TypeInfoRepository::getDottedTypes() const {
    auto names = getTypes();
    for (auto& name : names) name = toDot(name);
    std::sort(names.begin(), names.end());
    return names;
}

std::string TypeInfoRepository::toDot(const std::string& name) const { return detail::dottedName(name); }

bool TypeInfoRepository::addType(TypeInfoGenerator* generator) {
    if (!generator) return false;
    std::unique_ptr<TypeInfoGenerator> owned(generator);
    const std::string name = generator->getTypeName();
    TypeInfo* info = generator->getTypeInfoObject();
    if (!info) return false;
    const bool isNew = getTypeById(info->getTypeId()) != info;
    std::unique_ptr<TypeInfo> ownedInfo(isNew ? info : nullptr);
    if (isNew ? !state_->isFree(name, info) : !aliasType(name, info)) return false;
    // A generator that installed itself is now owned by the type. Its own reference would keep it alive for ever.
    const bool disposable = generator->installTypeInfoObject(info);
    if (!isNew && *info->getArrayElement()) {
        std::lock_guard<std::mutex> lock(state_->mutex);
        state_->byArrayElement.emplace(info->getArrayElement(), info);
    }
    if (generator->self_) {
        (void)owned.release();
        const auto keepDuringReset = std::move(generator->self_);
    } else if (!disposable) {
        (void)owned.release();
    }
    return !isNew || addType(ownedInfo.release());
}

bool TypeInfoRepository::addType(TypeInfo* info) {
    if (!info) return false;
    std::vector<TransportPlugin*> transports;
    {
        std::unique_ptr<TypeInfo> owned(info);
        std::lock_guard<std::mutex> lock(state_->mutex);
        if (!state_->byName.emplace(info->getTypeName(), info).second) {
            log(Error) << "refusing type " << info->getTypeName() << ": the name belongs to another type already"
                       << endlog();
            return false;
        }
        for (const auto& name : info->getTypeNames())
            if (state_->byName.emplace(name, info).first->second != info)
                log(Error) << "type " << info->getTypeName() << " is not called " << name
                           << ": the name belongs to another type already" << endlog();
        if (*info->getTypeIdName()) state_->byId.emplace(info->getTypeIdName(), info);
        if (*info->getArrayElement()) state_->byArrayElement.emplace(info->getArrayElement(), info);
        state_->types.push_back(std::move(owned));
        transports = state_->transports;
    }
    for (auto* transport : transports) transport->registerTransport(info->getTypeName(), info);
    return true;
}

bool TypeInfoRepository::aliasType(const std::string& alias, TypeInfo* info) {
    if (!info || !state_->isFree(alias, info)) return false;
    {
        std::lock_guard<std::mutex> lock(state_->mutex);
        const auto own = state_->byName.find(info->getTypeName());
        const bool isRegistered = own != state_->byName.end() && own->second == info;
        if (isRegistered && state_->byName.emplace(alias, info).first->second != info) return false;
    }
    // For a name that is new to the type, addAlias() calls this again and finds it. If the type is not registered yet,
    // addType() takes its names.
    info->addAlias(alias);
    return true;
}

void TypeInfoRepository::registerTransport(TransportPlugin* transport) {
    std::vector<TypeInfo*> known;
    {
        std::lock_guard<std::mutex> lock(state_->mutex);
        state_->transports.push_back(transport);
        for (const auto& type : state_->types) known.push_back(type.get());
    }
    transport->registerTransport("unknown_t", unknownType());
    for (auto* type : known) transport->registerTransport(type->getTypeName(), type);
}

void TypeInfoRepository::setAutoLoader(const boost::function<bool(const std::string&)>& loader) {
    std::lock_guard<std::mutex> lock(state_->mutex);
    state_->autoLoader = loader;
}

void TypeInfoRepository::logTypeInfo() const {
    for (const auto& name : getTypes()) {
        const TypeInfo* info = state_->find(name);
        log(Debug) << "type " << name << ", C++ type " << info->getTypeIdName() << ", protocols:";
        for (const int protocol : info->getTransportNames()) log() << ' ' << protocol;
        log() << endlog();
    }
}

namespace detail {
TypeInfo* knownOrNewType(const std::string& name, const std::type_info& id) {
    TypeInfo* known = Types()->getTypeById(&id);
    return known ? known : new TypeInfo(name, &id);
}
}  // namespace detail

}  // namespace RTT::types
