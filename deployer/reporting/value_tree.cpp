// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_tree.hpp"

#include "record.hpp"

#include <rtt/Property.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/SequenceOps.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <algorithm>
#include <cstring>
#include <typeinfo>
#include <utility>

namespace OCL::reporting {
namespace {

using Value = ValueTree::Value;
using RTT::PropertyBag;

bool isOfType(const Value& value, const std::type_info& type) {
    const std::type_info* const id = value->getTypeId();
    return id && std::strcmp(id->name(), type.name()) == 0;
}

const PropertyBag* bagOf(const Value& value) {
    return isOfType(value, typeid(PropertyBag)) ? static_cast<const PropertyBag*>(value->getRawConstPointer())
                                                : nullptr;
}

/** The value with the number of elements of a sequence, counted whenever it is read; null if this is not a sequence. A
    struct may have a member `size` as well, but that can be assigned. */
Value countOf(const Value& value, const std::vector<std::string>& members) {
    for (const char* name : {"size", "capacity"})
        if (std::find(members.begin(), members.end(), name) == members.end()) return nullptr;
    const Value count = value->getMember("size");
    return count && !count->isAssignable() && isOfType(count, typeid(int)) ? count : nullptr;
}

int numberIn(const Value& count) {
    return count->evaluate() ? *static_cast<const int*>(count->getRawConstPointer()) : 0;
}

}  // namespace

ValueTree::ValueTree(std::string name, Value value, Decomposition decomposition, OtherValues& others)
    : name_(std::move(name)), value_(std::move(value)), decomposition_(decomposition), others_(&others) {
    decide();
}

void ValueTree::decide() {
    const std::type_info* const id = value_->getTypeId();
    if (value_->hasFixedAddress()) fixed_ = value_->getRawConstPointer();
    encode_ = id ? encodeOf(*id) : nullptr;
    if (encode_) {
        kind_ = Kind::Leaf;
    } else if (decomposition_ != Decomposition::None && bagOf(value_)) {
        kind_ = Kind::Bag;
        (void)takeMembers();
    } else if (decomposition_ == Decomposition::Types) {
        kind_ = takeMembers() ? Kind::Bag : Kind::Text;
    } else if (decomposition_ == Decomposition::Members && id && (numbers_ = numberVectorOf(*id))) {
        kind_ = Kind::Numbers;
    } else if (decomposition_ == Decomposition::Members) {
        (void)becomeGroup();
    }
    if (kind_ == Kind::Text) other_ = others_->of(*value_->getTypeInfo());
}

bool ValueTree::becomeGroup() {
    const std::vector<std::string> members = value_->getMemberNames();
    count_ = countOf(value_, members);
    if (count_) {
        becomeList();
        return true;
    }
    for (const std::string& name : members) addPart(name, value_->getMember(name));
    if (parts_.empty()) return false;
    kind_ = Kind::Group;
    return true;
}

void ValueTree::becomeList() {
    kind_ = Kind::List;
    findElement();
    (void)resize(numberIn(count_));
}

/** Takes a default value of the elements' type apart, because there may be no elements yet. */
void ValueTree::findElement() {
    const RTT::types::Shape shape = value_->getTypeInfo()->shape();
    const char* const id = shape.elements ? shape.elements->elementType() : value_->getTypeInfo()->getArrayElement();
    const RTT::types::TypeInfo* const type = id && *id ? RTT::types::Types()->getTypeById(id) : nullptr;
    if (!type || !others_->open.insert(type).second) return;
    const Value example = type->buildValue();
    if (example && example->getRawPointer()) {
        const ValueTree element("", example, decomposition_, *others_);
        if (element.isFixed()) element_.reset(new Field(element.field()));
    }
    others_->open.erase(type);
}

/** True if all values of the type have the same fields. */
bool ValueTree::isFixed() const {
    if (kind_ == Kind::Bag || (kind_ == Kind::List && !element_)) return false;
    return std::all_of(parts_.begin(), parts_.end(), [](const ValueTree& part) { return part.isFixed(); });
}

void ValueTree::addPart(const std::string& name, const Value& part) {
    if (part) parts_.emplace_back(name, part, decomposition_, *others_);
}

bool ValueTree::resize(int size) {
    if (size == size_) return false;
    parts_.clear();
    for (int i = 0; i < size; ++i) addPart(std::to_string(i), value_->getMember(std::to_string(i)));
    size_ = size;
    return true;
}

const void* ValueTree::address() const {
    if (fixed_) return fixed_;
    (void)value_->evaluate();
    return value_->getRawConstPointer();
}

bool ValueTree::encode(Record& record) {
    switch (kind_) {
        case Kind::Leaf: encode_(address(), record); return false;
        case Kind::Text: {
            if (!other_) {
                (void)value_->evaluate();
                record.text(Tag::Text, textOf(value_));
                return false;
            }
            record.value(Tag::Other, other_);
            record.bytes(address(), other_->size());
            return false;
        }
        case Kind::Numbers: {
            const void* const vector = address();
            record.value(Tag::Sequence, static_cast<std::uint32_t>(numbers_->size(vector)));
            numbers_->encode(vector, record);
            return false;
        }
        case Kind::List: {
            bool changed = resize(numberIn(count_)) && !element_;
            if (element_)
                record.value(Tag::Sequence, static_cast<std::uint32_t>(parts_.size()));
            else
                record.tag(Tag::Bag);
            for (ValueTree& part : parts_) changed |= part.encode(record);
            return changed;
        }
        case Kind::Group: {
            bool changed = false;
            record.tag(Tag::Bag);
            for (ValueTree& part : parts_) changed |= part.encode(record);
            return changed;
        }
        case Kind::Bag: return encodeBag(record);
    }
    return false;
}

/** Converts the present value to a bag. */
bool ValueTree::currentBag(PropertyBag& bag) const {
    (void)value_->evaluate();
    if (const PropertyBag* const given = bagOf(value_)) return RTT::copyProperties(bag, *given);
    return RTT::types::typeDecomposition(value_, bag, true);
}

/** Makes the present members of the value the parts of this node. */
bool ValueTree::takeMembers() {
    PropertyBag bag;
    parts_.clear();
    if (!currentBag(bag)) return false;
    for (RTT::base::PropertyBase* item : bag) addPart(item->getName(), item->getDataSource());
    return true;
}

bool ValueTree::encodeBag(Record& record) {
    std::string before, now;
    appendSignature(before);
    (void)takeMembers();
    appendSignature(now);
    record.tag(Tag::Bag);
    for (ValueTree& part : parts_) (void)part.encode(record);
    return now != before;
}

void ValueTree::appendSignature(std::string& text) const {
    text.append(name_).push_back('\0');
    text.append(value_->getTypeInfo()->getTypeIdName()).push_back('\0');
    if (element_) return;
    for (const ValueTree& part : parts_) part.appendSignature(text);
    text.push_back('\1');
}

Field ValueTree::leaf() const {
    Field field;
    if (kind_ == Kind::Leaf) {
        field.type.number = numberOf(*value_->getTypeId());
    } else if (other_) {
        RTT::types::Shape shape = value_->getTypeInfo()->shape();
        if (shape.kind == RTT::types::Shape::Kind::Enumeration) {
            field.type.number = Number::Enumeration;
            field.type.numbers = shape.numbers;
            field.type.enumerators = std::move(shape.enumerators);
        }
    }
    return field;
}

Field ValueTree::field() const {
    Field field = kind_ == Kind::Leaf || kind_ == Kind::Text ? leaf() : Field();
    field.name = name_;
    const RTT::types::TypeInfo& type = *value_->getTypeInfo();
    if (kind_ == Kind::Numbers || element_) {
        const RTT::types::Shape shape = type.shape();
        field.kind = Field::Kind::Sequence;
        field.mayGrow = shape.elements ? shape.elements->resize != nullptr : *type.getArrayElement() == '\0';
        field.parts.push_back(element_ ? *element_ : Field());
        if (!element_) field.parts.front().type.number = numbers_->number;
    } else if (kind_ == Kind::Group || kind_ == Kind::List || kind_ == Kind::Bag) {
        field.kind = Field::Kind::Group;
        const auto members = kind_ == Kind::Group ? type.getMemberFactory() : nullptr;
        const PropertyBag* const bag = bagOf(value_);
        for (std::size_t i = 0; i != parts_.size(); ++i) {
            field.parts.push_back(parts_[i].field());
            if (members)
                describe(field.parts.back(), members->describeMember(parts_[i].name_));
            else if (bag && i < bag->size())
                describe(field.parts.back(), bag->getItem(static_cast<int>(i))->getDescription());
        }
    }
    return field;
}

void ValueTree::addTypesWithoutText(std::set<std::string>& types) const {
    for (const ValueTree& part : parts_) part.addTypesWithoutText(types);
    const RTT::types::TypeInfo& type = *value_->getTypeInfo();
    if (kind_ == Kind::Text && textOf(value_) == "(" + type.getTypeName() + ")") types.insert(type.getTypeName());
}

void ValueTree::addTo(PropertyBag& bag) {
    if (kind_ == Kind::Leaf || (kind_ == Kind::Text && decomposition_ == Decomposition::None)) {
        (void)value_->evaluate();
        const Value copy = value_->getTypeInfo()->buildValue();
        if (copy && copy->update(value_.get())) bag.ownProperty(copy->getTypeInfo()->buildProperty(name_, "", copy));
        return;
    }
    if (kind_ == Kind::Text) {
        (void)value_->evaluate();
        bag.ownProperty(new RTT::Property<std::string>(name_, "", textOf(value_)));
        return;
    }
    auto* const group = new RTT::Property<PropertyBag>(name_, "");
    group->value().setType(value_->getTypeName());
    bag.ownProperty(group);
    if (kind_ == Kind::Bag) {
        PropertyBag members;
        if (currentBag(members)) group->set(members);
        return;
    }
    if (kind_ == Kind::Numbers || count_) {
        const int size = count_ ? numberIn(count_) : static_cast<int>(numbers_->size(address()));
        for (int i = 0; i < size; ++i) {
            const std::string name = std::to_string(i);
            if (const Value part = value_->getMember(name))
                ValueTree(name, part, decomposition_, *others_).addTo(group->value());
        }
        return;
    }
    for (ValueTree& part : parts_) part.addTo(group->value());
}

}  // namespace OCL::reporting
