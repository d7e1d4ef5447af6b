// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads what the spelling of C++ types and names reveals, without a compiler.
#ifndef OROFORGE_GENERATOR_MODEL_CPP_TYPE_HPP
#define OROFORGE_GENERATOR_MODEL_CPP_TYPE_HPP

#include <string>
#include <vector>

namespace oroforge::model {

enum class TypeClass {
    Boolean,
    Signed,
    Unsigned,
    Float,      ///< float
    Double,     ///< double
    Character,  ///< char
    String,     ///< std::string
    Other       ///< only the compiler knows
};

/// "unsigned int" → Unsigned, "std::uint8_t" → Unsigned, "tank::Mode" → Other. Blanks make no difference.
TypeClass classify(const std::string& type);

/// Returns the bits of the integer types that classify() knows (as on 64-bit Linux); 0 for all others.
unsigned integerBits(const std::string& type);

bool isInteger(TypeClass type);
/// True for integers, float and double: these types can have a range.
bool isNumber(TypeClass type);

/// Leaves one blank between words and none elsewhere: "std::vector< double >" → "std::vector<double>".
std::string normalised(const std::string& type);

bool isIdentifier(const std::string& name);
bool isKeyword(const std::string& name);

/// "a::b::C" → {"a", "b", "C"}
std::vector<std::string> splitQualified(const std::string& name);

}  // namespace oroforge::model

#endif
