// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "reference_cdr.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/VariantTable.hpp>

namespace oroforge::test {

using RTT::types::Shape;
using RTT::types::TypeInfo;

namespace {

const TypeInfo* known(const char* type) { return RTT::types::Types()->getTypeById(type); }

}  // namespace

void ReferenceCdr::putNumber(const void* value, std::size_t size) {
    bytes_.resize((bytes_.size() + size - 1) / size * size);
    std::string number(static_cast<const char*>(value), size);
    if (order_ != RTT::encoding::kNativeOrder) std::reverse(number.begin(), number.end());
    bytes_ += number;
}

void ReferenceCdr::putCount(std::size_t count) {
    const auto number = static_cast<std::uint32_t>(count);
    putNumber(&number, sizeof number);
}

void ReferenceCdr::put(const char* type, const void* value) {
    const TypeInfo* const info = known(type);
    if (info == nullptr) throw std::runtime_error(std::string("no type ") + type);
    put(*info, value);
}

void ReferenceCdr::put(const TypeInfo& type, const void* value) {
    const Shape shape = type.shape();
    switch (shape.kind) {
        case Shape::Kind::Number:
        case Shape::Kind::Enumeration: return putNumber(value, shape.ops->size);
        case Shape::Kind::Text: {
            const std::string_view text = shape.text->get(value);
            putCount(text.size() + 1);
            bytes_ += text;
            bytes_ += '\0';
            return;
        }
        case Shape::Kind::Struct: return putFields(shape, value);
        case Shape::Kind::Sequence: return putElements(shape, value);
        case Shape::Kind::Variant: {
            const std::size_t index = shape.variant->index(value);
            putCount(index);
            const char* const chosen = shape.fields.at(index).type;
            if (known(chosen) != nullptr) put(chosen, shape.variant->elements.at(const_cast<void*>(value), index));
            return;
        }
        case Shape::Kind::Shown: {
            const auto shown = known(shape.shown->type())->buildValue();
            shape.shown->show(value, shown->getRawPointer());
            return put(shape.shown->type(), shown->getRawConstPointer());
        }
        case Shape::Kind::None: throw std::runtime_error(type.getTypeName() + ": " + shape.reason);
    }
}

void ReferenceCdr::putPart(const char* type, const RTT::types::SequenceOps& ops, const void* whole, std::size_t index) {
    const auto part = known(type)->buildValue();
    ops.load(whole, index, part->getRawPointer());
    put(type, part->getRawConstPointer());
}

void ReferenceCdr::putFields(const Shape& shape, const void* value) {
    bool isEmpty = true;
    for (const Shape::Field& field : shape.fields) {
        if (field.access != nullptr && field.access->store == nullptr && field.access->at == nullptr) continue;
        isEmpty = false;
        if (field.access != nullptr) {
            putPart(field.type, *field.access, value, 0);
            continue;
        }
        const std::size_t size = known(field.type)->getOps()->size;
        for (std::size_t i = 0; i != std::max<std::size_t>(1, field.count); ++i)
            put(field.type, static_cast<const char*>(value) + field.offset + i * size);
    }
    if (isEmpty) bytes_ += '\0';
}

void ReferenceCdr::putElements(const Shape& shape, const void* value) {
    const RTT::types::SequenceOps& ops = *shape.elements;
    const std::size_t count = ops.size(value);
    if (ops.resize != nullptr) putCount(count);
    for (std::size_t i = 0; i != count; ++i) putPart(ops.elementType(), ops, value, i);
}

}  // namespace oroforge::test
