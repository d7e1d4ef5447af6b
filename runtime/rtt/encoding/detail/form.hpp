// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_DETAIL_FORM_HPP
#define ORO_ENCODING_DETAIL_FORM_HPP

#include <rtt/types/SequenceOps.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/TypeOps.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace RTT {
namespace encoding {
namespace detail {

struct Form;

/** A field of a struct. */
struct FormField {
    std::string name;
    const Form* form;
    std::size_t offset;
    std::size_t count;                 // 0 if it is not an array
    const types::SequenceOps* access;  // null if it has an offset
    const char* doc = "";
    const char* unit = "";

    bool isReadOnly() const { return access && !access->store && !access->at; }
};

/** Numbers of one size, one after another in memory. */
struct FormNumbers {
    std::size_t offset, count;
    std::uint8_t size;
    bool isBool;
};

/** A step of encoding a struct: one field, or numbers without gaps between them. */
struct FormStep {
    const FormField* field = nullptr;  // null for numbers
    std::size_t offset = 0, bytes = 0;
    std::uint8_t align = 1;  // one copy is enough where the encoding is at a multiple of this
    bool hasBool = false;    // bytes must be checked before they become values
    std::vector<FormNumbers> numbers;
};

/**
 * The shape of a type with the shapes of all its parts, and how its values are encoded. Forms of one Plan point to each
 * other; a type that contains itself has one form.
 */
struct Form {
    types::Shape shape;

    /** Of a struct. A variant has one for each alternative, whose form is null if it has no value. */
    std::vector<FormField> fields;
    std::vector<FormStep> steps;  // of a struct; without its read-only fields
    const Form* element = nullptr;
    std::size_t fixedCount = 0;  // of a sequence without resize()
    bool hasRows = false;        // of a matrix: sequences of one length, which the first one decides
    const Form* shown = nullptr;
    std::vector<long long> byRank;  // the values of enumerators, if these are encoded by their rank

    std::uint8_t numberSize = 0;  // bytes of a number or an enumerator in the encoding
    /** Numbers, and structs of nothing but numbers without gaps: the encoding has the bytes of memory where it is at a
        multiple of `align`. */
    bool isSolid = false;
    bool hasBool = false;
    std::uint8_t align = 1;
    std::size_t least = 1;      // no value has fewer bytes
    bool hasFixedSize = false;  // it depends on nothing but the position

    std::size_t size() const { return shape.ops->size; }
};

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif
