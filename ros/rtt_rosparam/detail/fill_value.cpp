// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "fill_value.hpp"

#include "xml_value.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/Temporary.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/VariantTable.hpp>
#include <rtt/types/visit_elements.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <variant>

namespace rtt_rosparam {

using RTT::base::DataSourceBase;
using RTT::base::PropertyBase;
using RTT::types::Temporary;
using RTT::types::SequenceOps;

namespace {

bool isBag(const char* type) { return std::strcmp(type, typeid(RTT::PropertyBag).name()) == 0; }

bool isReadOnly(const RTT::types::Shape::Field& field) {
    return field.access && !field.access->store && !field.access->at;
}

}  // namespace

void Filler::refuse(const char* type, const Value& from, const std::string& why) const {
    std::string text = "parameter '" + path_ + "' is " + described(from) + ", which cannot be a value of type " +
                       Shapes::nameOf(type);
    if (!why.empty()) text += ": " + why;
    if (!property_.empty()) text += " (" + property_ + ')';
    throw Failure(text);
}

template <class Part>
void Filler::within(const std::string& part, Part fillPart) {
    const std::size_t length = path_.size();
    path_ += part;
    if (++depth_ > kDeepest) throw Failure("parameter '" + path_ + "' nests too deeply");
    fillPart();
    --depth_;
    path_.resize(length);
}

void Filler::prepare(PropertyBase& property, const Value& from) {
    const DataSourceBase::shared_ptr source = property.getDataSource();
    const std::type_info* const id = source ? source->getTypeId() : nullptr;
    if (!id) throw Failure("property '" + property.getName() + "' has no value");
    if (isBag(id->name())) {
        // The items of the bag itself: a copy of it shares those that it does not own.
        const RTT::PropertyBag& bag = *static_cast<const RTT::PropertyBag*>(source->getRawConstPointer());
        return prepareBag(id->name(), const_cast<RTT::PropertyBag&>(bag), from);
    }
    const std::string outer = property_;
    property_ = "property '" + property.getName() + "' of type " + Shapes::nameOf(id->name());
    std::unique_ptr<PropertyBase> copy(property.clone());
    fill(id->name(), from, copy->getDataSource()->getRawPointer());
    pending_.push_back({&property, std::move(copy)});
    property_ = outer;
}

void Filler::commit() {
    for (const Pending& one : pending_) {
        const DataSourceBase::shared_ptr target = one.property->getDataSource();
        if (!target->assignValue(one.value->getDataSource()->getRawConstPointer()))
            throw Failure("property '" + one.property->getName() + "' cannot be changed");
        target->updated();
    }
    pending_.clear();
}

void Filler::fill(const char* type, const Value& from, void* to) {
    if (isBag(type)) return fillBag(type, *static_cast<RTT::PropertyBag*>(to), from);
    const Shape& shape = shapes_.of(type);
    switch (shape.kind) {
        case Shape::Kind::Number: return fillNumber(type, shape.number, from, to);
        case Shape::Kind::Text: {
            if (from.getType() != Value::TypeString) refuse(type, from);
            const auto& letters = as<std::string>(from);
            return shape.text->set(to, letters.data(), letters.size());
        }
        case Shape::Kind::Enumeration: return fillEnumerator(type, shape, from, to);
        case Shape::Kind::Struct: return fillStruct(type, shape, from, to);
        case Shape::Kind::Sequence: return fillSequence(type, *shape.elements, from, to);
        case Shape::Kind::Variant: return fillVariant(type, shape, from, to);
        case Shape::Kind::Shown: return fillShown(type, shape, from, to);
        case Shape::Kind::None: return fillDecomposed(type, shape, from, to);
    }
}

template <class Number>
void Filler::fillReal(const char* type, const Value& from, void* to) {
    double exact = 0;
    if (from.getType() == Value::TypeDouble)
        exact = as<double>(from);
    else if (from.getType() == Value::TypeInt)
        exact = as<int>(from);
    else
        refuse(type, from);
    if (std::isfinite(exact) && std::abs(exact) > static_cast<double>(std::numeric_limits<Number>::max()))
        refuse(type, from, "it is out of range");
    const auto number = static_cast<Number>(exact);
    std::memcpy(to, &number, sizeof number);
}

template <class Number>
void Filler::fillWhole(const char* type, const Value& from, void* to) {
    if (from.getType() != Value::TypeInt) refuse(type, from);
    typedef std::numeric_limits<Number> Limits;
    const std::int64_t exact = as<int>(from);
    const bool isBelow = exact < 0 && (!Limits::is_signed || exact < static_cast<std::int64_t>(Limits::min()));
    const bool isAbove = exact > 0 && static_cast<std::uint64_t>(exact) > static_cast<std::uint64_t>(Limits::max());
    if (isBelow || isAbove) refuse(type, from, "it is out of range");
    const auto number = static_cast<Number>(exact);
    std::memcpy(to, &number, sizeof number);
}

void Filler::fillNumber(const char* type, Shape::Number number, const Value& from, void* to) {
    switch (number) {
        case Shape::Number::Bool: {
            if (from.getType() != Value::TypeBoolean) refuse(type, from);
            std::memcpy(to, &as<bool>(from), sizeof(bool));
            return;
        }
        case Shape::Number::Char: return fillWhole<char>(type, from, to);
        case Shape::Number::Int8: return fillWhole<std::int8_t>(type, from, to);
        case Shape::Number::UInt8: return fillWhole<std::uint8_t>(type, from, to);
        case Shape::Number::Int16: return fillWhole<std::int16_t>(type, from, to);
        case Shape::Number::UInt16: return fillWhole<std::uint16_t>(type, from, to);
        case Shape::Number::Int32: return fillWhole<std::int32_t>(type, from, to);
        case Shape::Number::UInt32: return fillWhole<std::uint32_t>(type, from, to);
        case Shape::Number::Int64: return fillWhole<std::int64_t>(type, from, to);
        case Shape::Number::UInt64: return fillWhole<std::uint64_t>(type, from, to);
        case Shape::Number::Float32: return fillReal<float>(type, from, to);
        case Shape::Number::Float64: return fillReal<double>(type, from, to);
    }
}

void Filler::fillEnumerator(const char* type, const Shape& shape, const Value& from, void* to) {
    const RTT::types::EnumOps& ops = *shape.numbers;
    std::string names;
    for (const Shape::Enumerator& one : shape.enumerators) {
        const bool isNumber = from.getType() == Value::TypeInt && as<int>(from) == one.value;
        if (isNumber || (from.getType() == Value::TypeString && as<std::string>(from) == one.name))
            return ops.set(to, one.value);
        names += (names.empty() ? "it is none of " : ", ") + one.name;
    }
    if (!names.empty() || from.getType() != Value::TypeInt) refuse(type, from, names);
    ops.set(to, as<int>(from));
    if (ops.get(to) != as<int>(from)) refuse(type, from, "it is out of range");
}

void Filler::fillStruct(const char* type, const Shape& shape, const Value& from, void* to) {
    if (from.getType() != Value::TypeStruct) refuse(type, from);
    for (const Shape::Field& field : shape.fields) {
        if (isReadOnly(field) || !from.hasMember(field.name)) continue;
        within('/' + field.name, [&] { fillField(field, from[field.name], to); });
    }
}

void Filler::fillField(const Shape::Field& field, const Value& from, void* to) {
    if (field.access && field.access->at) return fill(field.type, from, field.access->at(to, 0));
    if (field.access) return fillPart(field.type, *field.access, from, to, 0);
    auto* const at = static_cast<unsigned char*>(to) + field.offset;
    if (field.count == 0) return fill(field.type, from, at);
    if (from.getType() != Value::TypeArray) refuse(field.type, from, "an array is needed");
    if (static_cast<std::size_t>(from.size()) != field.count)
        refuse(field.type, from, "an array of " + std::to_string(field.count) + " elements is needed");
    const RTT::types::TypeOps* const ops = shapes_.of(field.type).ops;
    if (!ops) refuse(field.type, from, shapes_.of(field.type).reason);
    for (std::size_t i = 0; i != field.count; ++i)
        within('[' + std::to_string(i) + ']',
               [&] { fill(field.type, from[static_cast<int>(i)], at + i * ops->size); });
}

/** A part that is copied out of its place. */
void Filler::fillPart(const char* type, const SequenceOps& ops, const Value& from, void* to, std::size_t index) {
    const Shape& shape = shapes_.of(type);
    if (!shape.ops || !shape.ops->construct) refuse(type, from, shape ? "it has no default value" : shape.reason);
    const Temporary part(*shape.ops);
    ops.load(to, index, part.at());  // members that the parameter lacks keep their values
    fill(type, from, part.at());
    try {
        ops.store(to, index, part.at());
    } catch (const std::exception& error) {  // of a setter
        refuse(type, from, error.what());
    }
}

void Filler::fillSequence(const char* type, const SequenceOps& ops, const Value& from, void* to) {
    if (from.getType() != Value::TypeArray) refuse(type, from);
    const auto size = static_cast<std::size_t>(from.size());
    if (size != 0 && shapes_.hasRows(ops)) {
        // The first row of a matrix decides how long all are.
        for (std::size_t i = 0; i != size; ++i) {
            const Value& row = from[static_cast<int>(i)];
            if (row.getType() != Value::TypeArray || row.size() != from[0].size())
                refuse(type, from, "its rows must be arrays of one length");
        }
        if (!ops.resize(to, 1) && ops.size(to) != size) refuse(type, from, "it has another number of rows");
        within("[0]", [&] { fillElement(ops, from[0], to, 0); });
    }
    const bool fits = !ops.resize  ? ops.size(to) == size
                      : ops.insert ? ops.resize(to, 0)
                                   : ops.resize(to, size) && ops.size(to) == size;
    if (!fits) refuse(type, from, "a value has " + std::to_string(ops.size(to)) + " elements");
    if (ops.at && ops.visit) {
        // An element is found by counting.
        int index = 0;
        RTT::types::visitWhile(ops, to, [&](const void* element) {
            within('[' + std::to_string(index) + ']',
                   [&] { fill(ops.elementType(), from[index], const_cast<void*>(element)); });
            ++index;
            return true;
        });
        return;
    }
    for (std::size_t i = 0; i != size; ++i)
        within('[' + std::to_string(i) + ']', [&] { fillElement(ops, from[static_cast<int>(i)], to, i); });
}

void Filler::fillElement(const SequenceOps& ops, const Value& from, void* to, std::size_t index) {
    const char* const type = ops.elementType();
    if (!ops.insert) return ops.at ? fill(type, from, ops.at(to, index)) : fillPart(type, ops, from, to, index);
    const Shape& shape = shapes_.of(type);
    if (!shape.ops || !shape.ops->construct) refuse(type, from, shape ? "it has no default value" : shape.reason);
    const Temporary element(*shape.ops);
    fill(type, from, element.at());
    ops.insert(to, element.at());
}

void Filler::fillVariant(const char* type, const Shape& shape, const Value& from, void* to) {
    if (from.getType() != Value::TypeStruct || !from.hasMember("alternative") ||
        from[std::string("alternative")].getType() != Value::TypeString)
        refuse(type, from, "a struct with the text 'alternative' is needed");
    const auto& name = as<std::string>(from[std::string("alternative")]);
    for (std::size_t i = 0; i != shape.fields.size(); ++i) {
        if (shape.fields[i].name != name) continue;
        if (shape.variant->index(to) != i) shape.variant->choose(to, i);
        const bool isEmpty = std::strcmp(shape.fields[i].type, typeid(std::monostate).name()) == 0;
        if (isEmpty || !from.hasMember("value")) return;
        return within("/value", [&] {
            fill(shape.fields[i].type, from[std::string("value")], shape.variant->elements.at(to, i));
        });
    }
    refuse(type, from, "it has no alternative '" + name + "'");
}

void Filler::fillShown(const char* type, const Shape& shape, const Value& from, void* to) {
    const char* const shownType = shape.shown->type();
    const Shape& other = shapes_.of(shownType);
    if (!other.ops || !other.ops->construct) refuse(type, from, other.reason);
    const Temporary shown(*other.ops);
    fill(shownType, from, shown.at());
    if (!shape.shown->take(shown.at(), to)) refuse(type, from, "there is no such value");
}

/** At once: the bag may be part of a value that does not live until commit(). */
void Filler::fillBag(const char* type, RTT::PropertyBag& bag, const Value& from) {
    Filler inner(path_);
    inner.property_ = property_;
    inner.depth_ = depth_;
    inner.prepareBag(type, bag, from);
    inner.commit();
}

void Filler::prepareBag(const char* type, RTT::PropertyBag& bag, const Value& from) {
    if (from.getType() != Value::TypeStruct) refuse(type, from);
    for (PropertyBase* const item : bag) {
        if (!item->ready() || !from.hasMember(item->getName())) continue;
        within('/' + item->getName(), [&] { prepare(*item, from[item->getName()]); });
    }
}

/** A type whose typekit only takes values apart and puts them together. */
void Filler::fillDecomposed(const char* type, const Shape& shape, const Value& from, void* to) {
    const RTT::types::TypeInfo* const info = RTT::types::Types()->getTypeById(type);
    const DataSourceBase::shared_ptr whole = info ? info->buildReference(to) : nullptr;
    RTT::PropertyBag members;
    if (!whole || !RTT::types::typeDecomposition(whole, members, true)) refuse(type, from, shape.reason);
    const boost::intrusive_ptr<RTT::internal::ValueDataSource<RTT::PropertyBag>> copies(
        new RTT::internal::ValueDataSource<RTT::PropertyBag>());
    RTT::copyProperties(copies->set(), members);
    copies->set().setType(members.getType());
    fillBag(type, copies->set(), from);
    if (!info->composeType(copies, whole)) refuse(type, from, "its typekit does not take these members");
}

}  // namespace rtt_rosparam
