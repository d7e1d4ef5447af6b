// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/configuration_servant.hpp>

#include <rtt/Logger.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <string>
#include <utility>

namespace RTT::corba::detail {

namespace {

typedef base::DataSourceBase::shared_ptr Source;

/** A list grows by one element, which this returns. */
template <class List>
auto& added(List& list) {
    const CORBA::ULong index = list.length();
    list.length(index + 1);
    return list[index];
}

void addProperties(corba::CConfigurationInterface::CPropertyNames& list, const PropertyBag& bag,
                   const std::string& prefix) {
    for (const base::PropertyBase* const one : bag) {
        const std::string path = prefix + one->getName();
        corba::CConfigurationInterface::CProperty& described = added(list);
        described.name = path.c_str();
        described.description = one->getDescription().c_str();
        described.type_name = one->getTypeInfo()->getTypeName().c_str();
        if (const auto* const inner = dynamic_cast<const Property<PropertyBag>*>(one))
            addProperties(list, inner->rvalue(), path + ".");
    }
}

char* text(const Source& source, std::string (*of)(base::DataSourceBase&)) {
    return CORBA::string_dup(source ? of(*source).c_str() : "na");
}
std::string typeOf(base::DataSourceBase& source) { return source.getType(); }
std::string typeNameOf(base::DataSourceBase& source) { return source.getTypeName(); }
std::string valueAsText(base::DataSourceBase& source) { return source.toString(); }

/** Text that is no value leaves the old one. */
bool isSetFrom(const Source& target, const char* text) {
    if (!target || !target->isAssignable()) return false;
    const Source made = target->getTypeInfo()->buildValue();
    if (!made || !made->update(target.get()) || !made->getTypeInfo()->fromString(text, made)) return false;
    if (!target->assignValue(made->getRawConstPointer())) return false;
    target->updated();
    return true;
}

bool isSet(const Source& target, const CORBA::Any& value) {
    return target && target->isAssignable() && assign(value, target);
}

}  // namespace

Source ConfigurationServant::attribute(const std::string& name) const {
    const base::AttributeBase* const found = service_->getValue(name);
    return found ? found->getDataSource() : nullptr;
}

Source ConfigurationServant::property(const std::string& name) const {
    const base::PropertyBase* const found = findProperty(*service_->properties(), name);
    return found ? found->getDataSource() : nullptr;
}

corba::CConfigurationInterface::CAttributeNames* ConfigurationServant::getAttributeList() {
    const ServedComponent::Use use(*served_);
    corba::CConfigurationInterface::CAttributeNames_var list = new corba::CConfigurationInterface::CAttributeNames();
    for (const base::AttributeBase* const one : service_->getValues()) {
        corba::CConfigurationInterface::CAttribute& described = added(list.inout());
        described.name = one->getName().c_str();
        described.type_name = one->getDataSource()->getTypeName().c_str();
        described.assignable = one->getDataSource()->isAssignable();
    }
    return list._retn();
}

corba::CConfigurationInterface::CPropertyNames* ConfigurationServant::getPropertyList() {
    const ServedComponent::Use use(*served_);
    corba::CConfigurationInterface::CPropertyNames_var list = new corba::CConfigurationInterface::CPropertyNames();
    addProperties(list.inout(), *service_->properties(), "");
    return list._retn();
}

CORBA::Any* ConfigurationServant::valueOf(const Source& source, const char* kind, const char* name) const {
    if (source && source->evaluate()) return newAny(source);
    log(Error) << "another process asks for the " << kind << " '" << name << "', which service '" << service_->getName()
               << "' does not have" << endlog();
    return new CORBA::Any();
}

CORBA::Any* ConfigurationServant::getAttribute(const char* name) {
    const ServedComponent::Use use(*served_);
    return valueOf(attribute(name), "attribute", name);
}

CORBA::Any* ConfigurationServant::getProperty(const char* name) {
    const ServedComponent::Use use(*served_);
    return valueOf(property(name), "property", name);
}

CORBA::Boolean ConfigurationServant::setAttribute(const char* name, const CORBA::Any& value) {
    const ServedComponent::Use use(*served_);
    return isSet(attribute(name), value);
}

CORBA::Boolean ConfigurationServant::setProperty(const char* name, const CORBA::Any& value) {
    const ServedComponent::Use use(*served_);
    return isSet(property(name), value);
}

CORBA::Boolean ConfigurationServant::hasAttribute(const char* name) {
    const ServedComponent::Use use(*served_);
    return attribute(name) != nullptr;
}

CORBA::Boolean ConfigurationServant::hasProperty(const char* name) {
    const ServedComponent::Use use(*served_);
    return property(name) != nullptr;
}

char* ConfigurationServant::getPropertyType(const char* name) {
    const ServedComponent::Use use(*served_);
    return text(property(name), &typeOf);
}

char* ConfigurationServant::getAttributeType(const char* name) {
    const ServedComponent::Use use(*served_);
    return text(attribute(name), &typeOf);
}

char* ConfigurationServant::getPropertyTypeName(const char* name) {
    const ServedComponent::Use use(*served_);
    return text(property(name), &typeNameOf);
}

char* ConfigurationServant::getAttributeTypeName(const char* name) {
    const ServedComponent::Use use(*served_);
    return text(attribute(name), &typeNameOf);
}

char* ConfigurationServant::attributeToString(const char* name) {
    const ServedComponent::Use use(*served_);
    return text(attribute(name), &valueAsText);
}

char* ConfigurationServant::propertyToString(const char* name) {
    const ServedComponent::Use use(*served_);
    return text(property(name), &valueAsText);
}

CORBA::Boolean ConfigurationServant::attributeFromString(const char* name, const char* value) {
    const ServedComponent::Use use(*served_);
    return isSetFrom(attribute(name), value);
}

CORBA::Boolean ConfigurationServant::propertyFromString(const char* name, const char* value) {
    const ServedComponent::Use use(*served_);
    return isSetFrom(property(name), value);
}

CORBA::Boolean ConfigurationServant::isAttributeAssignable(const char* name) {
    const ServedComponent::Use use(*served_);
    const Source found = attribute(name);
    return found && found->isAssignable();
}

}  // namespace RTT::corba::detail
