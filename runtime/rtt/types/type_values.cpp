// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The objects that a TypeInfo makes: by a factory that a typekit installed, or by the table of thunks; otherwise none.
#include "TypeInfo.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include "CompositionFactory.hpp"
#include "MemberFactory.hpp"
#include "Operators.hpp"
#include "StreamFactory.hpp"
#include "TypeThunkTable.hpp"
#include "ValueFactory.hpp"
#include <rtt/types/detail/type_info_state.hpp>
#include <istream>
#include <ostream>
#include <sstream>

namespace RTT::types {

using base::DataSourceBase;

namespace {
bool holdsThisType(const TypeInfo& type, const DataSourceBase::shared_ptr& source) {
    return source && source->getTypeId() && type.getTypeId() && *source->getTypeId() == *type.getTypeId();
}

/** Calls `thunk` if the type has a table with that entry. */
template <class R, class... P, class... A>
R callThunk(const TypeInfo& type, R (*TypeThunks::*thunk)(P...), A&&... arguments) {
    const TypeThunks* table = type.getThunks();
    return table && table->*thunk ? (table->*thunk)(std::forward<A>(arguments)...) : R();
}
}  // namespace

TypeInfo::SourcePtr TypeInfo::construct(const std::vector<SourcePtr>& arguments) const {
    if (arguments.size() == 1 && holdsThisType(*this, arguments.front())) return arguments.front();
    for (const auto& constructor : state_->currentConstructors())
        if (SourcePtr made = constructor->build(arguments)) return made;
    return arguments.empty() ? buildValue() : nullptr;
}

TypeInfo::SourcePtr TypeInfo::convert(SourcePtr source) const {
    if (!source || holdsThisType(*this, source)) return source;
    for (const auto& constructor : state_->currentConstructors())
        if (SourcePtr made = constructor->convert(source)) return made;
    return source;
}

bool TypeInfo::convertType(SourcePtr source, SourcePtr target) const {
    return source && target && target->update(convert(source).get());
}

TypeInfo::SourcePtr TypeInfo::convertType(SourcePtr source) const {
    const SourcePtr simpler = decomposeType(source);
    const bool isBag = simpler && simpler->getTypeId() && *simpler->getTypeId() == typeid(PropertyBag);
    return simpler && !isBag ? simpler : source;
}

TypeInfo::SourcePtr TypeInfo::buildValue() const {
    if (auto factory = getValueFactory()) return factory->buildValue();
    return callThunk(*this, &TypeThunks::value);
}

TypeInfo::SourcePtr TypeInfo::buildReference(void* value) const {
    if (auto factory = getValueFactory()) return factory->buildReference(value);
    return callThunk(*this, &TypeThunks::reference, value);
}

TypeInfo::SourcePtr TypeInfo::buildActionAlias(base::ActionInterface* action, SourcePtr source) const {
    if (auto factory = getValueFactory()) return factory->buildActionAlias(action, source);
    return callThunk(*this, &TypeThunks::actionAlias, action, source.get());
}

base::AttributeBase* TypeInfo::buildConstant(std::string name, SourcePtr value, int sizehint) const {
    const SourcePtr converted = convert(value);
    if (!converted) return nullptr;
    if (auto factory = getValueFactory()) return factory->buildConstant(name, converted, sizehint);
    return callThunk(*this, &TypeThunks::constant, name, converted.get());
}

base::AttributeBase* TypeInfo::buildConstant(std::string name, SourcePtr value) const {
    return buildConstant(name, value, 0);
}

base::AttributeBase* TypeInfo::buildVariable(std::string name, int sizehint) const {
    auto factory = getValueFactory();
    base::AttributeBase* made =
        factory ? factory->buildVariable(name, sizehint) : callThunk(*this, &TypeThunks::variable, name, sizehint);
    if (made && sizehint > 0) resize(made->getDataSource(), sizehint);
    return made;
}

base::AttributeBase* TypeInfo::buildVariable(std::string name) const { return buildVariable(name, 0); }

base::AttributeBase* TypeInfo::buildAttribute(std::string name, SourcePtr source) const {
    if (auto factory = getValueFactory()) return factory->buildAttribute(name, source);
    return callThunk(*this, &TypeThunks::attribute, name, source.get());
}

base::AttributeBase* TypeInfo::buildAlias(std::string name, SourcePtr source) const {
    if (auto factory = getValueFactory()) return factory->buildAlias(name, source);
    return holdsThisType(*this, source) ? new Alias(name, source) : nullptr;
}

base::PropertyBase* TypeInfo::buildProperty(const std::string& name, const std::string& description,
                                            SourcePtr source) const {
    if (auto factory = getValueFactory()) return factory->buildProperty(name, description, source);
    return callThunk(*this, &TypeThunks::property, name, description, source.get());
}

std::ostream& TypeInfo::write(std::ostream& os, SourcePtr source) const {
    if (auto factory = getStreamFactory()) return factory->write(os, source);
    return os << '(' << getTypeName() << ')';
}

std::istream& TypeInfo::read(std::istream& is, SourcePtr target) const {
    if (auto factory = getStreamFactory()) return factory->read(is, target);
    is.setstate(std::ios::failbit);
    return is;
}

std::string TypeInfo::toString(SourcePtr source) const {
    if (auto factory = getStreamFactory()) return factory->toString(source);
    return '(' + getTypeName() + ')';
}

bool TypeInfo::fromString(const std::string& text, SourcePtr target) const {
    auto factory = getStreamFactory();
    return factory && factory->fromString(text, target);
}

bool TypeInfo::isStreamable() const {
    auto factory = getStreamFactory();
    return factory && factory->isStreamable();
}

bool TypeInfo::resize(SourcePtr source, int size) const {
    auto factory = getMemberFactory();
    return factory && source && size >= 0 && factory->resize(source, size);
}

std::vector<std::string> TypeInfo::getMemberNames() const {
    auto factory = getMemberFactory();
    return factory ? factory->getMemberNames() : std::vector<std::string>();
}

TypeInfo::SourcePtr TypeInfo::getMember(SourcePtr item, const std::string& name) const {
    if (!item) return nullptr;
    auto factory = getMemberFactory();
    const SourcePtr member = factory ? factory->getMember(item, name) : nullptr;
    return member ? member : SourcePtr(operators()->applyDot(name, item.get()));
}

TypeInfo::SourcePtr TypeInfo::getMember(SourcePtr item, SourcePtr id) const {
    auto factory = getMemberFactory();
    return factory && item && id ? factory->getMember(item, id) : nullptr;
}

bool TypeInfo::getMember(internal::Reference* reference, SourcePtr item, const std::string& name) const {
    auto factory = getMemberFactory();
    return factory && item && factory->getMember(reference, item, name);
}

bool TypeInfo::composeType(SourcePtr source, SourcePtr target) const {
    if (!source || !target) return false;
    if (target->update(source.get())) return true;
    auto factory = getCompositionFactory();
    return factory && factory->composeType(source, target);
}

TypeInfo::SourcePtr TypeInfo::decomposeType(SourcePtr source) const {
    auto factory = getCompositionFactory();
    return factory && source ? factory->decomposeType(source) : nullptr;
}

base::InputPortInterface* TypeInfo::inputPort(const std::string& name) const {
    if (auto factory = getPortFactory()) return factory->inputPort(name);
    return callThunk(*this, &TypeThunks::inputPort, name);
}

base::OutputPortInterface* TypeInfo::outputPort(const std::string& name) const {
    if (auto factory = getPortFactory()) return factory->outputPort(name);
    return callThunk(*this, &TypeThunks::outputPort, name);
}

base::ChannelElementBase::shared_ptr TypeInfo::buildDataStorage(const ConnPolicy& policy) const {
    if (auto factory = getPortFactory()) return factory->buildDataStorage(policy);
    return callThunk(*this, &TypeThunks::dataStorage, policy);
}

base::ChannelElementBase::shared_ptr TypeInfo::buildChannelOutput(base::InputPortInterface& port,
                                                                  const ConnPolicy& policy) const {
    if (auto factory = getPortFactory()) return factory->buildChannelOutput(port, policy);
    return internal::ConnFactory::makeChannelOutput(port, policy);
}

base::ChannelElementBase::shared_ptr TypeInfo::buildChannelInput(base::OutputPortInterface& port,
                                                                 const ConnPolicy& policy) const {
    if (auto factory = getPortFactory()) return factory->buildChannelInput(port, policy);
    return internal::ConnFactory::makeChannelInput(port, policy);
}

}  // namespace RTT::types
