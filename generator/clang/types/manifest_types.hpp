// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Looks C++ types up where generated code uses them: after the typekit's headers, in the namespace of a class.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_MANIFEST_TYPES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_MANIFEST_TYPES_HPP

#include <string>
#include <vector>

namespace oroforge::cxx {

struct TypeQuestion {
    std::string space;  ///< namespace in which it is used
    std::string type;
    std::string value;  ///< a default; empty if not given
};

struct TypeAnswer {
    std::string fault;                     ///< the compiler's error about the type; empty if it is one
    std::string noValue;                   ///< why values of the class cannot be described; empty if they can
    std::vector<std::string> enumerators;  ///< of an enum: "tank::Mode::idle"
    std::string valueFault;                ///< the compiler's error about the default of an enum
};

struct TypeLookup {
    bool isSound = true;               ///< all headers were found and understood
    std::vector<TypeAnswer> answers;   ///< one for each question
    std::vector<std::string> names;    ///< all types in the headers and their includes, except system headers
    std::vector<std::string> headers;  ///< files that were read, except system headers
};

struct TypeLookupRequest {
    std::vector<std::string> headers;          ///< of the typekit
    std::vector<std::string> standardHeaders;  ///< "vector"
    std::vector<std::string> flags;            ///< -I -isystem -D …, each word one element
    std::vector<TypeQuestion> questions;
};

/// Without a compiler, the result is not sound.
TypeLookup lookUpTypes(const TypeLookupRequest& request);

}  // namespace oroforge::cxx

#endif
