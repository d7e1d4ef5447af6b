// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "shape_filler.hpp"

#include <rtt/types/SequenceOps.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/Temporary.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/VariantTable.hpp>

#include <cstring>
#include <string>

namespace oroforge::test {

namespace {

using namespace RTT::types;

constexpr unsigned kDeepest = 4;

class Filler {
public:
    explicit Filler(unsigned seed) : next_(seed) {}

    void fill(const char* type, void* value) {
        if (const TypeInfo* const known = Types()->getTypeById(type)) fill(*known, value);
    }
    void fill(const TypeInfo& type, void* value) {
        const Shape shape = type.shape();
        switch (shape.kind) {
            case Shape::Kind::Number: number(shape.number, value); break;
            case Shape::Kind::Text: text(shape, value); break;
            case Shape::Kind::Enumeration:
                if (!shape.enumerators.empty())
                    shape.numbers->set(value, shape.enumerators[next_++ % shape.enumerators.size()].value);
                break;
            case Shape::Kind::Struct:
                for (const Shape::Field& field : shape.fields) fillField(field, value);
                break;
            case Shape::Kind::Sequence:
                ++depth_;
                sequence(*shape.elements, value);
                --depth_;
                break;
            case Shape::Kind::Variant: {
                const std::size_t chosen = next_++ % shape.variant->count;
                shape.variant->choose(value, chosen);
                fill(shape.variant->types[chosen](), shape.variant->elements.at(value, chosen));
                break;
            }
            default: break;
        }
    }

private:
    template <class T>
    static void put(T number, void* to) {
        std::memcpy(to, &number, sizeof number);
    }
    void number(Shape::Number kind, void* to) {
        const unsigned n = next_++;
        switch (kind) {
            case Shape::Number::Bool: put(n % 2 != 0, to); break;
            case Shape::Number::Char: put(static_cast<char>('a' + n % 26), to); break;
            case Shape::Number::Int8: put(static_cast<std::int8_t>(-static_cast<int>(n % 100)), to); break;
            case Shape::Number::UInt8: put(static_cast<std::uint8_t>(n % 256), to); break;
            case Shape::Number::Int16: put(static_cast<std::int16_t>(-300 - static_cast<int>(n % 100)), to); break;
            case Shape::Number::UInt16: put(static_cast<std::uint16_t>(60000 + n % 100), to); break;
            case Shape::Number::Int32: put(static_cast<std::int32_t>(-70000 - static_cast<int>(n)), to); break;
            case Shape::Number::UInt32: put(static_cast<std::uint32_t>(4000000000U + n), to); break;
            case Shape::Number::Int64: put(static_cast<std::int64_t>(-9000000000000000000LL - n), to); break;
            case Shape::Number::UInt64: put(static_cast<std::uint64_t>(18000000000000000000ULL + n), to); break;
            case Shape::Number::Float32: put(static_cast<float>(n) + 0.1F, to); break;
            case Shape::Number::Float64: put(n + 0.1, to); break;
        }
    }
    void text(const Shape& shape, void* value) {
        const std::string letters = "text " + std::to_string(next_++) + " \xc3\xbc\"";
        shape.text->set(value, letters.data(), letters.size());
    }
    void fillField(const Shape::Field& field, void* whole) {
        const TypeInfo* const type = Types()->getTypeById(field.type);
        if (!type) return;
        if (field.access) {
            if (field.access->at) return fill(*type, field.access->at(whole, 0));
            if (!field.access->store || !type->getOps()->construct) return;
            const Temporary part(*type->getOps());
            field.access->load(whole, 0, part.at());
            fill(*type, part.at());
            return field.access->store(whole, 0, part.at());
        }
        auto* at = static_cast<unsigned char*>(whole) + field.offset;
        for (std::size_t i = 0; i != (field.count == 0 ? 1 : field.count); ++i, at += type->getOps()->size)
            fill(*type, at);
    }
    void sequence(const SequenceOps& ops, void* value) {
        const TypeInfo* const type = Types()->getTypeById(ops.elementType());
        if (!type || depth_ > kDeepest) return;
        if (ops.resize && !ops.resize(value, 2) && !ops.resize(value, 1)) return;
        const std::size_t count = ops.insert ? 2 : ops.size(value);
        for (std::size_t i = 0; i != count; ++i) {
            if (ops.at) {
                fill(*type, ops.at(value, i));
                continue;
            }
            if (!type->getOps()->construct) return;
            const Temporary part(*type->getOps());
            if (!ops.insert) ops.load(value, i, part.at());
            fill(*type, part.at());
            ops.insert ? static_cast<void>(ops.insert(value, part.at())) : ops.store(value, i, part.at());
        }
    }

    unsigned next_, depth_ = 0;
};

}  // namespace

void fillShape(const RTT::types::TypeInfo& type, void* value, unsigned seed) { Filler(seed).fill(type, value); }

}  // namespace oroforge::test
