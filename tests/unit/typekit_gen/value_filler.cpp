// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_filler.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

namespace oroforge::test {

using RTT::base::DataSourceBase;
using RTT::types::TypeInfo;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

bool has(const std::vector<std::string>& names, const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

int sizeOf(const SourcePtr& value) {
    const SourcePtr member = value->getMember("size");
    auto* const size = RTT::internal::DataSource<int>::narrow(member.get());
    return size != nullptr ? size->get() : -1;
}

/// The set or map of that type, by what the model says; null if it is none.
const model::TypeUse* keyed(const model::TypeModel& model, const SourcePtr& value) {
    for (const model::TypeUse& use : model.library) {
        const bool isKeyed = use.kind == model::TypeKind::Set || use.kind == model::TypeKind::Map;
        if (isKeyed && RTT::types::Types()->type(use.name) == value->getTypeInfo()) return &use;
    }
    return nullptr;
}

constexpr unsigned kDeepest = 6;  // of types that hold themselves

}  // namespace

void ValueFiller::fill(const SourcePtr& value, const std::string& path) {
    const TypeInfo& type = *value->getTypeInfo();
    const std::vector<std::string> members = type.getMemberNames();
    if (depth_ == kDeepest) return;
    ++depth_;
    if (type.isStreamable()) {
        fillLeaf(value);
        paths_.push_back(path);
    } else if (members == std::vector<std::string>{"alternative", "value"}) {
        if (const SourcePtr inner = value->getMember("value")) fill(inner, path + ".value");
    } else if (has(members, "size") && has(members, "capacity")) {
        fillElements(value, path);
    } else {
        for (const std::string& name : members) {
            const SourcePtr member = value->getMember(name);
            ASSERT_TRUE(member) << path << "." << name;
            fill(member, path + "." + name);
            member->updated();
        }
    }
    --depth_;
}

void ValueFiller::fillLeaf(const SourcePtr& value) {
    const TypeInfo& type = *value->getTypeInfo();
    const unsigned number = 1 + ++next_ % 3;  // fits into all bit-fields
    const auto* const enumeration = dynamic_cast<const RTT::types::Enumeration*>(type.getCompositionFactory().get());
    // Files may give no other values.
    const auto names = enumeration ? enumeration->enumerators() : std::vector<std::string>();
    if (!names.empty() && type.fromString(names[number % names.size()], value)) {
        value->updated();
        return;
    }
    if (type.fromString(std::to_string(number), value) || type.fromString(number % 2 ? "true" : "false", value) ||
        type.fromString(number % 2 ? "101" : "11", value)) {
        value->updated();
        return;
    }
    ADD_FAILURE() << "no value for " << type.getTypeName();
}

void ValueFiller::fillElements(const SourcePtr& value, const std::string& path) {
    if (fillKeyed(value)) {
        paths_.push_back(path);
        return;
    }
    const TypeInfo& type = *value->getTypeInfo();
    if (!type.resize(value, 2)) type.resize(value, 1);
    for (int i = 0; i != sizeOf(value); ++i) {
        const std::string index = std::to_string(i);
        const SourcePtr element = value->getMember(index);
        ASSERT_TRUE(element) << path;
        fill(element, path + "[" + index + "]");
        element->updated();
    }
}

bool ValueFiller::fillKeyed(const SourcePtr& value) {
    const model::TypeUse* use = keyed(model_, value);
    if (use == nullptr) return false;
    // The runtime's own types have the names of C++.
    const model::TypeUse& key = use->element.front();
    std::string element = key.kind == model::TypeKind::String ? "string" : key.cpp;
    if (use->kind == model::TypeKind::Map) element = "/KeyValue<" + key.name + "," + use->element.back().name + ">";
    const TypeInfo* type = RTT::types::Types()->type(element);
    if (type == nullptr) {
        ADD_FAILURE() << "no type " << element;
        return true;
    }
    RTT::PropertyBag bag;
    for (const char* name : {"Element0", "Element1"}) {
        const SourcePtr item = type->buildValue();
        ValueFiller inner(model_, next_++);
        inner.depth_ = depth_;
        inner.fill(item);
        bag.ownProperty(type->buildProperty(name, "", item));
    }
    const SourcePtr source(new RTT::internal::ConstReferenceDataSource<RTT::PropertyBag>(bag));
    EXPECT_TRUE(value->getTypeInfo()->composeType(source, value));
    EXPECT_EQ(sizeOf(value), 2) << value->toString();
    return true;
}

}  // namespace oroforge::test
