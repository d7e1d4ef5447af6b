// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "DataSourceBase.hpp"

#include <rtt/internal/values/detail/assign_value_action.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <ostream>
#include <sstream>

namespace RTT {

const char* internal::bad_assignment::what() const noexcept {
    return "no assignment between the types of the two data sources";
}

namespace base {

void intrusive_ptr_add_ref(const DataSourceBase* source) noexcept { source->ref(); }

void intrusive_ptr_release(const DataSourceBase* source) noexcept { source->deref(); }

DataSourceBase::~DataSourceBase() = default;

void DataSourceBase::deref() const noexcept {
    // acq_rel: changes by other owners must be visible to the destructor.
    if (refs_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

void DataSourceBase::reset() {}

bool DataSourceBase::isAssignable() const { return false; }

bool DataSourceBase::assignValue(const void*) { return false; }

const std::type_info* DataSourceBase::getTypeId() const { return nullptr; }

DataSourceBase* DataSourceBase::knownCopy(const std::map<const DataSourceBase*, DataSourceBase*>& alreadyCloned) const {
    const auto found = alreadyCloned.find(this);
    return found == alreadyCloned.end() ? nullptr : found->second;
}

void DataSourceBase::noteCopy(std::map<const DataSourceBase*, DataSourceBase*>& alreadyCloned,
                              DataSourceBase* made) const {
    alreadyCloned[this] = made;
}

bool DataSourceBase::hasTypeOf(const DataSourceBase& other) const {
    const std::type_info* mine = getTypeId();
    const std::type_info* theirs = other.getTypeId();
    return mine && theirs && *mine == *theirs;
}

bool DataSourceBase::update(DataSourceBase* other) {
    if (!other || !isAssignable() || !hasTypeOf(*other) || !other->evaluate()) return false;
    return assignValue(other->getRawConstPointer());
}

ActionInterface* DataSourceBase::updateAction(DataSourceBase* other) {
    if (!other || !isAssignable()) throw bad_assignment();
    const shared_ptr source = hasTypeOf(*other) ? shared_ptr(other) : getTypeInfo()->convert(other);
    if (!source || !hasTypeOf(*source)) throw bad_assignment();
    return new internal::AssignValueAction(this, source);
}

void DataSourceBase::updated() {}

std::string DataSourceBase::getTypeName() const { return getTypeInfo()->getTypeName(); }

std::ostream& DataSourceBase::write(std::ostream& os) { return getTypeInfo()->write(os, this); }

std::string DataSourceBase::toString() {
    std::ostringstream text;
    write(text);
    return text.str();
}

DataSourceBase::shared_ptr DataSourceBase::getParent() { return this; }

DataSourceBase::shared_ptr DataSourceBase::getMember(const std::string& name) {
    if (name.empty()) return this;
    const auto dot = name.find('.');
    if (dot != std::string::npos)
        if (const shared_ptr outer = getTypeInfo()->getMember(this, name.substr(0, dot)))
            return outer->getMember(name.substr(dot + 1));
    return getTypeInfo()->getMember(this, name);
}

DataSourceBase::shared_ptr DataSourceBase::getMember(shared_ptr id) { return getTypeInfo()->getMember(this, id); }

std::vector<std::string> DataSourceBase::getMemberNames() const { return getTypeInfo()->getMemberNames(); }

void* DataSourceBase::getRawPointer() { return nullptr; }

const void* DataSourceBase::getRawConstPointer() { return nullptr; }

std::ostream& operator<<(std::ostream& os, const DataSourceBase::shared_ptr& source) {
    return source ? source->write(os) : os << "(null)";
}

}  // namespace base
}  // namespace RTT
