// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "other_value.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/types/TypeOps.hpp>

#include <cstring>
#include <typeinfo>

namespace OCL::reporting {

using Value = RTT::base::DataSourceBase::shared_ptr;

std::string textOf(const Value& value) {
    const Value simpler = value->getTypeInfo()->decomposeType(value);
    const std::type_info* const type = simpler ? simpler->getTypeId() : nullptr;
    const bool isBag = type && *type == typeid(RTT::PropertyBag);
    return simpler && !isBag ? simpler->toString() : value->toString();
}

OtherValue::OtherValue(Value place, std::size_t size) : place_(std::move(place)), size_(size) {}

std::string OtherValue::text(const char* bytes) const {
    std::memcpy(place_->getRawPointer(), bytes, size_);
    place_->updated();
    return textOf(place_);
}

const OtherValue* OtherValues::of(const RTT::types::TypeInfo& type) {
    const RTT::types::TypeOps* const ops = type.getOps();
    const char* const element = type.getArrayElement();
    if (!ops || !ops->trivial || (element && *element)) return nullptr;  // copying a view does not copy its elements
    std::unique_ptr<OtherValue>& made = known_[&type];
    if (!made) {
        const Value place = type.buildValue();
        if (!place || !place->getRawPointer()) return nullptr;
        made.reset(new OtherValue(place, ops->size));
    }
    return made.get();
}

}  // namespace OCL::reporting
