// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_tree.hpp"

#include "record.hpp"

#include <rtt/Property.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <cstring>
#include <typeinfo>

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
        size_ = static_cast<int>(numbers_->size(address()));
    } else if (decomposition_ == Decomposition::Members && becomeGroup()) {
        kind_ = Kind::Group;
    }
    if (kind_ == Kind::Text) other_ = others_->of(*value_->getTypeInfo());
}

bool ValueTree::becomeGroup() {
    const std::vector<std::string> members = value_->getMemberNames();
    count_ = countOf(value_, members);
    if (count_) {
        (void)resize(numberIn(count_));
        return true;
    }
    for (const std::string& name : members) addPart(name, value_->getMember(name));
    return !parts_.empty();
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
    if (record.named()) record.text(Tag::Name, name_);
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
            const int before = std::exchange(size_, static_cast<int>(numbers_->size(vector)));
            record.tag(Tag::Bag);
            numbers_->encode(vector, record);
            encodeEnd(record);
            return size_ != before;
        }
        case Kind::Group: {
            bool changed = count_ && resize(numberIn(count_));
            record.tag(Tag::Bag);
            for (ValueTree& part : parts_) changed |= part.encode(record);
            encodeEnd(record);
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
    appendNames(before);
    (void)takeMembers();
    appendNames(now);
    record.tag(Tag::Bag);
    for (ValueTree& part : parts_) (void)part.encode(record);
    encodeEnd(record);
    return now != before;
}

std::size_t ValueTree::elements() const {
    return kind_ == Kind::Numbers ? static_cast<std::size_t>(size_) : parts_.size();
}

void ValueTree::encodeEnd(Record& record) const {
    if (record.named())
        record.tag(Tag::End);
    else if (elements() == 0)
        record.value(Tag::Unsigned, std::uint64_t{0});
}

void ValueTree::appendNames(std::string& line, const std::string& name) const {
    if (kind_ == Kind::Leaf || kind_ == Kind::Text) {
        line += ' ' + name;
        return;
    }
    const std::size_t count = elements();
    if (count == 0) line += ' ' + name + "[0]";
    for (std::size_t i = 0; i < count; ++i) {
        if (kind_ == Kind::Numbers)
            line += ' ' + name + '.' + std::to_string(i);
        else if (parts_[i].name_.empty())
            parts_[i].appendNames(line, name + '.' + std::to_string(i + 1));
        else
            parts_[i].appendNames(line, name + '.' + parts_[i].name_);
    }
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
