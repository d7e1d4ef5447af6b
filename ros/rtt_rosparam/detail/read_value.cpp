// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_value.hpp"

#include <ros/names.h>
#include <rtt/PropertyBag.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/Temporary.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/VariantTable.hpp>
#include <rtt/types/visit_elements.hpp>

#include <cstdint>
#include <cstring>
#include <limits>
#include <variant>

namespace rtt_rosparam {

using RTT::base::DataSourceBase;
using RTT::types::Temporary;
using RTT::types::SequenceOps;

namespace {

template <class T>
T at(const void* place) {
    T value;
    std::memcpy(&value, place, sizeof value);
    return value;
}

Reader::Value emptyStruct() {
    Reader::Value made;
    (void)made.begin();  // makes it one
    return made;
}

Reader::Value emptyArray() {
    Reader::Value made;
    made.setSize(0);
    return made;
}

/** The number of bytes of the letter of UTF-8 at the begin of the text; 0 if there is none. */
std::size_t letterSize(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t size = first < 0x80 ? 1 : first >= 0xC2 && first < 0xE0 ? 2 : (first & 0xF0) == 0xE0 ? 3 : 4;
    if (size == 1) return 1;
    if (size > text.size() || (size == 4 && (first < 0xF0 || first > 0xF4))) return 0;
    for (std::size_t i = 1; i != size; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    const bool isLonger = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool isSurrogate = first == 0xED && byte(1) >= 0xA0;
    const bool isBeyond = first == 0xF4 && byte(1) >= 0x90;
    const bool isNoLetter = first == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE;
    return isLonger || isSurrogate || isBeyond || isNoLetter ? 0 : size;
}

/** Why XML cannot carry this text; null if it can. */
const char* problemOf(std::string_view text) {
    for (std::size_t i = 0; i != text.size();) {
        const auto letter = static_cast<unsigned char>(text[i]);
        if (letter < ' ' && letter != '\t' && letter != '\n')
            return "its text has a control character, which XML-RPC cannot carry";
        const std::size_t size = letterSize(text.substr(i));
        if (size == 0) return "its text is not UTF-8";
        i += size;
    }
    return nullptr;
}

}  // namespace

bool isParameterName(const std::string& name) {
    std::string why;
    return !name.empty() && name.find('/') == std::string::npos && ros::names::validate('/' + name, why);
}

void Reader::refuse(const char* type, const std::string& why) const {
    throw Failure("a value of type " + Shapes::nameOf(type) + " cannot be the parameter '" + path_ + "': " + why);
}

template <class Part>
Reader::Value Reader::within(const std::string& part, Part readPart) {
    const std::size_t length = path_.size();
    path_ += part;
    if (++depth_ > kDeepest) throw Failure("the value of parameter '" + path_ + "' nests too deeply");
    Value made = readPart();
    --depth_;
    path_.resize(length);
    return made;
}

Reader::Value Reader::read(const RTT::base::PropertyBase& property) {
    const DataSourceBase::shared_ptr source = property.getDataSource();
    if (!source || !source->getTypeId() || !source->evaluate())
        throw Failure("property '" + property.getName() + "' has no value");
    return read(source->getTypeId()->name(), source->getRawConstPointer());
}

Reader::Value Reader::read(const char* type, const void* from) {
    if (std::strcmp(type, typeid(RTT::PropertyBag).name()) == 0)
        return readBag(*static_cast<const RTT::PropertyBag*>(from));
    const Shape& shape = shapes_.of(type);
    switch (shape.kind) {
        case Shape::Kind::Number: return readNumber(type, shape.number, from);
        case Shape::Kind::Text: return readText(type, shape.text->get(from));
        case Shape::Kind::Enumeration: return readEnumerator(type, shape, from);
        case Shape::Kind::Struct: return readStruct(shape, from);
        case Shape::Kind::Sequence: return readSequence(*shape.elements, from);
        case Shape::Kind::Variant: return readVariant(type, shape, from);
        case Shape::Kind::Shown: return readShown(type, shape, from);
        case Shape::Kind::None: break;
    }
    return readDecomposed(type, shape, from);
}

template <class Number>
Reader::Value Reader::whole(const char* type, Number number) {
    const bool isBelow = number < 0 && static_cast<long long>(number) < std::numeric_limits<int>::min();
    const bool isAbove = number > 0 && static_cast<unsigned long long>(number) >
                                           static_cast<unsigned long long>(std::numeric_limits<int>::max());
    if (isBelow || isAbove)
        refuse(type, std::to_string(number) + " does not fit into the 32 bits of an int of XML-RPC");
    return Value(static_cast<int>(number));
}

Reader::Value Reader::readNumber(const char* type, Shape::Number number, const void* from) {
    switch (number) {
        case Shape::Number::Bool: return Value(at<std::uint8_t>(from) != 0);
        case Shape::Number::Char: return whole<int>(type, at<char>(from));
        case Shape::Number::Int8: return whole<int>(type, at<std::int8_t>(from));
        case Shape::Number::UInt8: return whole<int>(type, at<std::uint8_t>(from));
        case Shape::Number::Int16: return whole<int>(type, at<std::int16_t>(from));
        case Shape::Number::UInt16: return whole<int>(type, at<std::uint16_t>(from));
        case Shape::Number::Int32: return whole(type, at<std::int32_t>(from));
        case Shape::Number::UInt32: return whole<long long>(type, at<std::uint32_t>(from));
        case Shape::Number::Int64: return whole<long long>(type, at<std::int64_t>(from));
        case Shape::Number::UInt64: return whole<unsigned long long>(type, at<std::uint64_t>(from));
        case Shape::Number::Float32: return Value(static_cast<double>(at<float>(from)));
        case Shape::Number::Float64: break;
    }
    return Value(at<double>(from));
}

Reader::Value Reader::readText(const char* type, std::string_view text) {
    if (const char* const problem = problemOf(text)) refuse(type, problem);
    return Value(std::string(text));
}

Reader::Value Reader::readEnumerator(const char* type, const Shape& shape, const void* from) {
    const long long number = shape.numbers->get(from);
    for (const Shape::Enumerator& one : shape.enumerators)
        if (one.value == number) return Value(one.name);
    return whole(type, number);
}

Reader::Value Reader::readStruct(const Shape& shape, const void* from) {
    Value made = emptyStruct();
    for (const Shape::Field& field : shape.fields) {
        // Nothing could set it from the parameter.
        if (field.access && !field.access->store && !field.access->at) continue;
        made[field.name] = within('/' + field.name, [&] { return readField(field, from); });
    }
    return made;
}

Reader::Value Reader::readField(const Shape::Field& field, const void* from) {
    if (field.access && field.access->at) return read(field.type, field.access->at(const_cast<void*>(from), 0));
    if (field.access) return readPart(field.type, *field.access, from, 0);
    const auto* const first = static_cast<const unsigned char*>(from) + field.offset;
    if (field.count == 0) return read(field.type, first);
    const RTT::types::TypeOps* const ops = shapes_.of(field.type).ops;
    if (!ops) refuse(field.type, shapes_.of(field.type).reason);
    Value made = emptyArray();
    made.setSize(static_cast<int>(field.count));
    for (std::size_t i = 0; i != field.count; ++i)
        made[static_cast<int>(i)] =
            within('[' + std::to_string(i) + ']', [&] { return read(field.type, first + i * ops->size); });
    return made;
}

/** A part that is copied out of its place. */
Reader::Value Reader::readPart(const char* type, const SequenceOps& ops, const void* from, std::size_t index) {
    const Shape& shape = shapes_.of(type);
    if (!shape.ops || !shape.ops->construct) refuse(type, shape ? "it has no default value" : shape.reason);
    const Temporary part(*shape.ops);
    ops.load(from, index, part.at());
    return read(type, part.at());
}

Reader::Value Reader::readSequence(const SequenceOps& ops, const void* from) {
    Value made = emptyArray();
    const char* const type = ops.elementType();
    const std::size_t size = ops.size(from);
    if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) refuse(type, "there are too many elements");
    made.setSize(static_cast<int>(size));
    int index = 0;
    const auto add = [&](auto readOne) {
        made[index] = within('[' + std::to_string(index) + ']', readOne);
        ++index;
    };
    if (ops.visit) {
        RTT::types::visitWhile(ops, from, [&](const void* element) {
            add([&] { return read(type, element); });
            return true;
        });
        return made;
    }
    for (std::size_t i = 0; i != size; ++i)
        add([&] { return ops.at ? read(type, ops.at(const_cast<void*>(from), i)) : readPart(type, ops, from, i); });
    return made;
}

Reader::Value Reader::readVariant(const char* type, const Shape& shape, const void* from) {
    const std::size_t index = shape.variant->index(from);
    if (index >= shape.fields.size()) refuse(type, "it has no alternative");
    const Shape::Field& chosen = shape.fields[index];
    Value made = emptyStruct();
    made["alternative"] = chosen.name;
    if (std::strcmp(chosen.type, typeid(std::monostate).name()) != 0)
        made["value"] = within("/value", [&] {
            return read(chosen.type, shape.variant->elements.at(const_cast<void*>(from), index));
        });
    return made;
}

Reader::Value Reader::readShown(const char* type, const Shape& shape, const void* from) {
    const Shape& other = shapes_.of(shape.shown->type());
    if (!other.ops || !other.ops->construct) refuse(type, other.reason);
    const Temporary shown(*other.ops);
    shape.shown->show(from, shown.at());
    return read(shape.shown->type(), shown.at());
}

Reader::Value Reader::readBag(const RTT::PropertyBag& bag) {
    Value made = emptyStruct();
    for (const RTT::base::PropertyBase* const item : bag) {
        if (!item->ready()) continue;
        if (!isParameterName(item->getName()))
            throw Failure("'" + item->getName() + "' cannot be the name of a parameter in '" + path_ +
                          "'; rename the property");
        made[item->getName()] = within('/' + item->getName(), [&] { return read(*item); });
    }
    return made;
}

/** A type whose typekit only takes values apart. */
Reader::Value Reader::readDecomposed(const char* type, const Shape& shape, const void* from) {
    const RTT::types::TypeInfo* const info = RTT::types::Types()->getTypeById(type);
    const DataSourceBase::shared_ptr whole = info ? info->buildReference(const_cast<void*>(from)) : nullptr;
    RTT::PropertyBag members;
    if (!whole || !RTT::types::typeDecomposition(whole, members, true)) refuse(type, shape.reason);
    return readBag(members);
}

}  // namespace rtt_rosparam
