// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_PART_TAKER_HPP
#define OROFORGE_SCHEMA_PART_TAKER_HPP

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace oroforge::schema {

enum class Basic : std::uint8_t;  // message_schema.hpp

/** Receives the parts of a message in their order. */
class PartTaker {
public:
    virtual ~PartTaker() = default;
    /** A union is a struct with the field that it has at the time, if any. */
    virtual void beginStruct() = 0;
    virtual void field(std::string_view name) = 0;
    virtual void endStruct() = 0;
    virtual void beginList() = 0;
    virtual void element(std::size_t index) = 0;
    virtual void endList() = 0;
    /** A number or truth value, as JSON writes it but for nan and inf. */
    virtual void number(std::string_view text) = 0;
    /** The same with its type; overridden by what needs it. */
    virtual void typedNumber(Basic, std::string_view text) { number(text); }
    virtual void text(std::string_view text) = 0;
};

}  // namespace oroforge::schema

#endif
