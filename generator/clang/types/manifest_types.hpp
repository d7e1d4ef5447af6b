// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Looks C++ types up where generated code will use them: behind the typekit's headers, in the namespace of a class.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_MANIFEST_TYPES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_MANIFEST_TYPES_HPP

#include <string>
#include <vector>

namespace oroforge::cxx {

struct TypeQuestion {
    std::string space;  ///< namespace in which it is written
    std::string type;
    std::string value;  ///< a default; empty if there is none
};

struct TypeAnswer {
    std::string fault;                     ///< what the compiler says to the type; empty if it is one
    std::string noValue;                   ///< why values of the class cannot be described; empty if they can
    std::vector<std::string> enumerators;  ///< of an enum: "tank::Mode::idle"
    std::string valueFault;                ///< of an enum: what the compiler says to the default
};

struct TypeLookup {
    bool isSound = true;               ///< all headers were found and make sense
    std::vector<TypeAnswer> answers;   ///< one for each question
    std::vector<std::string> names;    ///< of all types in the headers and what they include, the system's left out
    std::vector<std::string> headers;  ///< files that were read, the system's left out
};

struct TypeLookupRequest {
    std::vector<std::string> headers;          ///< of the typekit
    std::vector<std::string> standardHeaders;  ///< "vector"
    std::vector<std::string> flags;            ///< -I -isystem -D …, each word one element
    std::vector<TypeQuestion> questions;
};

/// Nothing is sound if there is no compiler.
TypeLookup lookUpTypes(const TypeLookupRequest& request);

}  // namespace oroforge::cxx

#endif
