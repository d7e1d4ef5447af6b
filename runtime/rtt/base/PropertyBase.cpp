// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "PropertyBase.hpp"

#include <rtt/Property.hpp>
#include <rtt/internal/values/property_update.hpp>
#include "PropertyIntrospection.hpp"
#include <ostream>

namespace RTT::base {

using internal::detail::BagUpdate;

PropertyBase::PropertyBase() = default;
PropertyBase::PropertyBase(const std::string& name, const std::string& description)
    : _name(name), _description(description) {}
PropertyBase::PropertyBase(const PropertyBase&) = default;
PropertyBase& PropertyBase::operator=(const PropertyBase&) = default;
PropertyBase::~PropertyBase() = default;

PropertyIntrospection::~PropertyIntrospection() = default;

void PropertyIntrospection::introspect(Property<unsigned char>& p) { introspect(static_cast<PropertyBase*>(&p)); }
void PropertyIntrospection::introspect(Property<short>& p) { introspect(static_cast<PropertyBase*>(&p)); }
void PropertyIntrospection::introspect(Property<unsigned short>& p) { introspect(static_cast<PropertyBase*>(&p)); }
void PropertyIntrospection::introspect(Property<long long>& p) { introspect(static_cast<PropertyBase*>(&p)); }
void PropertyIntrospection::introspect(Property<unsigned long long>& p) { introspect(static_cast<PropertyBase*>(&p)); }

namespace {
template <class T>
bool visitAs(PropertyBase* property, PropertyIntrospection& visitor) {
    auto* typed = dynamic_cast<Property<T>*>(property);
    if (typed) visitor.introspect(*typed);
    return typed != nullptr;
}

template <class... T>
bool visitAsOneOf(PropertyBase* property, PropertyIntrospection& visitor) {
    return (visitAs<T>(property, visitor) || ...);
}

BagUpdate takingValues() {
    BagUpdate how;
    how.report = internal::detail::logUpdateError;
    return how;
}
}  // namespace

void PropertyBase::identify(PropertyIntrospection* visitor) const {
    auto* self = const_cast<PropertyBase*>(this);
    if (!visitAsOneOf<bool, char, int, unsigned int, double, float, std::string, PropertyBag, unsigned char, short,
                      unsigned short, long long, unsigned long long>(self, *visitor))
        visitor->introspect(self);
}

bool PropertyBase::ready() const { return getDataSource() != nullptr; }

std::string PropertyBase::getType() const {
    const auto source = getDataSource();
    return source ? source->getType() : std::string("unknown_t");
}

const types::TypeInfo* PropertyBase::getTypeInfo() const {
    const auto source = getDataSource();
    return source ? source->getTypeInfo() : nullptr;
}

bool PropertyBase::update(const PropertyBase* other) {
    if (!other || !ready() || !other->ready()) return false;
    BagUpdate how = takingValues();
    how.addMissing = true;
    how.fillDescriptions = true;
    return internal::detail::updateOne(*this, *other, how);
}

bool PropertyBase::refresh(const PropertyBase* other) {
    return other && ready() && other->ready() && internal::detail::updateOne(*this, *other, takingValues());
}

bool PropertyBase::copy(const PropertyBase* other) {
    if (!other || !ready() || !other->ready()) return false;
    if (!getDataSource()->update(other->getDataSource().get())) return false;
    _name = other->_name;
    _description = other->_description;
    return true;
}

ActionInterface* PropertyBase::refreshCommand(const PropertyBase* other) {
    if (!other || !ready() || !other->ready()) return nullptr;
    try {
        return getDataSource()->updateAction(other->getDataSource().get());
    } catch (const bad_assignment&) {
        return nullptr;
    }
}

ActionInterface* PropertyBase::updateCommand(const PropertyBase* other) { return refreshCommand(other); }

ActionInterface* PropertyBase::copyCommand(const PropertyBase* other) { return refreshCommand(other); }

DataSourceBase::shared_ptr PropertyBase::getMember(const std::string& name) const {
    const auto source = getDataSource();
    return source ? source->getMember(name) : nullptr;
}

std::ostream& operator<<(std::ostream& os, PropertyBase* property) {
    if (!property || !property->ready()) return os << "(null)";
    return os << property->getDataSource();
}

}  // namespace RTT::base
