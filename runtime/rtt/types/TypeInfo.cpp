// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Identity, factories and transports of types; values and members are in type_values.cpp.
#include "TypeInfo.hpp"

#include <rtt/Logger.hpp>
#include <rtt/internal/plugin_loading.hpp>
#include "TypeInfoRepository.hpp"
#include <rtt/types/detail/type_info_state.hpp>
#include <algorithm>

namespace RTT::types {

TypeInfo::TypeInfo(std::string name, TypeId id) : state_(new State(std::move(name), id)) {}

TypeInfo::~TypeInfo() = default;

const std::string& TypeInfo::getTypeName() const { return state_->name; }

std::vector<std::string> TypeInfo::getTypeNames() const {
    return state_->locked([this] {
        std::vector<std::string> names{state_->name};
        names.insert(names.end(), state_->aliases.begin(), state_->aliases.end());
        return names;
    });
}

bool TypeInfo::addAlias(const std::string& alias) {
    auto& known = state_->aliases;
    const bool isNew = state_->locked([&] {
        if (alias == state_->name || std::find(known.begin(), known.end(), alias) != known.end()) return false;
        known.push_back(alias);
        return true;
    });
    if (!isNew || Types()->aliasType(alias, this)) return isNew;
    return state_->locked([&] {
        known.erase(std::remove(known.begin(), known.end(), alias), known.end());
        return false;
    });
}

bool TypeInfo::isType(const std::string& name) const {
    const auto names = getTypeNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool TypeInfo::setTypeId(TypeId id) {
    state_->id.store(id, std::memory_order_release);
    return true;
}

TypeInfo::TypeId TypeInfo::getTypeId() const { return state_->id.load(std::memory_order_acquire); }

const char* TypeInfo::getTypeIdName() const {
    const TypeId id = getTypeId();
    return id ? id->name() : "";
}

const std::string& TypeInfo::getDescription() const { return state_->description; }

void TypeInfo::setDescription(const std::string& text) {
    // The first description stays, because callers may have a reference to it.
    state_->locked([&] {
        if (state_->description.empty()) state_->description = text;
        return true;
    });
}

void TypeInfo::addConstructor(TypeConstructor* constructor) {
    std::shared_ptr<TypeConstructor> owned(constructor);
    if (owned)
        state_->locked([&] {
            auto& all = state_->constructors;
            const auto isLast = [](const auto& one) {
                return dynamic_cast<const detail::AskedLast*>(one.get()) != nullptr;
            };
            all.insert(isLast(owned) ? all.end() : std::find_if(all.begin(), all.end(), isLast), owned);
            return true;
        });
}

bool TypeInfo::addProtocol(int protocol, TypeTransporter* transporter) {
    std::unique_ptr<TypeTransporter> owned(transporter);
    if (!owned) return false;
    const bool isGeneric = owned->isGeneric();
    const bool added = state_->locked([&] {
        std::unique_ptr<TypeTransporter>& present = state_->transporters[protocol];
        if (present && (isGeneric || !present->isGeneric())) return false;
        if (present) state_->replaced.push_back(std::move(present));
        present = std::move(owned);
        state_->keepQuick(protocol, present.get());
        return true;
    });
    if (!added)
        log(Debug) << "protocol " << protocol << " of type " << getTypeName() << " is registered already" << endlog();
    return added;
}

TypeTransporter* TypeInfo::State::transporter(int protocol) const {
    if (isQuick(protocol))
        if (TypeTransporter* const found = quick[static_cast<std::size_t>(protocol)].load(std::memory_order_acquire))
            return found;
    const auto registered = [&]() -> TypeTransporter* {
        const auto it = transporters.find(protocol);
        return it == transporters.end() ? nullptr : it->second.get();
    };
    if (TypeTransporter* const found = locked(registered)) return found;
    (void)internal::loadTransportPlugin(protocol);  // another thread may have loaded it by now
    return locked(registered);
}

bool TypeInfo::hasProtocol(int protocol) const { return state_->transporter(protocol) != nullptr; }

TypeTransporter* TypeInfo::getProtocol(int protocol) const {
    if (TypeTransporter* const found = state_->transporter(protocol)) return found;
    TypeInfo* unknown = Types()->unknownType();
    if (unknown != this && unknown->hasProtocol(protocol)) return unknown->getProtocol(protocol);
    log(Warning) << "type " << getTypeName() << " has no transport for protocol " << protocol
                 << ", and that protocol has none for unknown types" << endlog();
    return nullptr;
}

std::vector<int> TypeInfo::getTransportNames() const {
    return state_->locked([this] {
        std::vector<int> protocols;
        for (const auto& entry : state_->transporters) protocols.push_back(entry.first);
        return protocols;
    });
}

void TypeInfo::setOps(const TypeOps* ops) { state_->ops.store(ops, std::memory_order_release); }
const TypeOps* TypeInfo::getOps() const { return state_->ops.load(std::memory_order_acquire); }
void TypeInfo::setThunks(const TypeThunks* thunks) { state_->thunks.store(thunks, std::memory_order_release); }
const TypeThunks* TypeInfo::getThunks() const { return state_->thunks.load(std::memory_order_acquire); }
void TypeInfo::setArrayElement(const char* idName) { state_->arrayElement.store(idName, std::memory_order_release); }
const char* TypeInfo::getArrayElement() const { return state_->arrayElement.load(std::memory_order_acquire); }

void TypeInfo::setValueFactory(ValueFactoryPtr factory) {
    state_->locked([&] {
        state_->values.swap(factory);
        return true;
    });
}
void TypeInfo::setMemberFactory(MemberFactoryPtr factory) {
    state_->locked([&] {
        state_->members.swap(factory);
        return true;
    });
}
void TypeInfo::setCompositionFactory(CompositionFactoryPtr factory) {
    state_->locked([&] {
        state_->compositions.swap(factory);
        return true;
    });
}
void TypeInfo::setStreamFactory(StreamFactoryPtr factory) {
    state_->locked([&] {
        state_->streams.swap(factory);
        return true;
    });
}
void TypeInfo::setPortFactory(ConnFactoryPtr factory) {
    state_->locked([&] {
        state_->ports.swap(factory);
        return true;
    });
}
ValueFactoryPtr TypeInfo::getValueFactory() const {
    return state_->locked([this] { return state_->values; });
}
MemberFactoryPtr TypeInfo::getMemberFactory() const {
    return state_->locked([this] { return state_->members; });
}
CompositionFactoryPtr TypeInfo::getCompositionFactory() const {
    return state_->locked([this] { return state_->compositions; });
}
StreamFactoryPtr TypeInfo::getStreamFactory() const {
    return state_->locked([this] { return state_->streams; });
}
ConnFactoryPtr TypeInfo::getPortFactory() const {
    return state_->locked([this] { return state_->ports; });
}

}  // namespace RTT::types
