// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The contents of adapter files: how to reach the values of a class with private storage. Plain data.
#ifndef OROFORGE_GENERATOR_ADAPTERS_ADAPTER_HPP
#define OROFORGE_GENERATOR_ADAPTERS_ADAPTER_HPP

#include <string>
#include <vector>

#include <adapters/accessor.hpp>

namespace oroforge::adapters {

enum class Shape { Struct, Sequence, Matrix };

/// Matches a template argument: "double", "-1", "$N" (any, which gets this name) or "..." (all that follow).
using Pattern = std::string;

struct Member {
    std::string name, also, doc, unit, range;
    Accessor get;
    Accessor set;  ///< if not given, the result of `get` is assigned to
    diag::Location where;
};

/// A constructor that scripts call as `Type(arguments)`.
struct Constructor {
    struct Argument {
        std::string type, name;  ///< a C++ type without "::" in front, or a "$variable"
        diag::Location where;
    };
    std::vector<Argument> arguments;
    Accessor call;  ///< a static function of the class; if not given, its constructor
    diag::Location where;
};

struct Adapter {
    Shape shape = Shape::Struct;
    std::string className;           ///< "Eigen::Matrix", without a leading "::"
    std::vector<Pattern> arguments;  ///< of a class template
    std::string name;                ///< in the type registry, with variables; empty = made from the C++ name
    std::string alias;               ///< another name
    std::string doc;
    std::vector<Member> members;   ///< of a struct
    Accessor size, rows, columns;  ///< a number if it never changes
    Accessor resize;               ///< if not given, the size is fixed
    Accessor element, set;         ///< like `get` and `set` of a member
    Accessor initial;              ///< a static function that makes the first value; if not given, `T()`
    std::vector<Constructor> constructors;
    diag::Location where;
    diag::Location classWhere;
    bool isShipped = false;  ///< with typegen
};

}  // namespace oroforge::adapters

#endif
