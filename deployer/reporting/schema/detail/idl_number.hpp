// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_IDL_NUMBER_HPP
#define OROFORGE_SCHEMA_IDL_NUMBER_HPP

#include "idl_names.hpp"
#include "idl_reader.hpp"

namespace oroforge::schema {

/** Reads an integer: a literal, a constant, an enumerator, or what is computed of them. False if it is not one. Within
    "<>" two ">" are not a shift. */
bool readNumber(IdlReader& reader, const IdlNames& names, const std::string& scope, std::int64_t& number,
                bool isWithinAngles = false);

}  // namespace oroforge::schema

#endif
