// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The state while a constructor is followed: values of variables, ports and the like, services.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_COMPONENT_STATE_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_COMPONENT_STATE_HPP

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <clang/base/llvm_compat.hpp>
#include <model/package.hpp>

#include "place.hpp"

namespace oroforge::cxx {

/// The value of an expression, as far as the source reveals it.
struct Value {
    enum class Kind {
        Unknown,
        Number,  ///< integers, characters and enumerators; all of them have a text, too
        Real,
        Boolean,
        Text,   ///< std::string and string literals
        Place,  ///< an object, or a pointer to it
        Null,
        Cpp,  ///< any other constant, as C++
        Function,
        Policy
    };

    Kind kind = Kind::Unknown;
    long long number = 0;
    double real = 0;
    std::string text;
    Place place;
    const clang::FunctionDecl* function = nullptr;
    model::Policy policy;

    bool known() const { return kind != Kind::Unknown; }
    bool is(Kind wanted) const { return kind == wanted; }

    static Value ofNumber(long long value) {
        Value made;
        made.kind = Kind::Number;
        made.number = value;
        return made;
    }
    static Value ofReal(double value) {
        Value made;
        made.kind = Kind::Real;
        made.real = value;
        return made;
    }
    static Value ofBoolean(bool value) {
        Value made;
        made.kind = Kind::Boolean;
        made.number = value ? 1 : 0;
        return made;
    }
    static Value ofText(std::string value, Kind kind = Kind::Text) {
        Value made;
        made.kind = kind;
        made.text = std::move(value);
        return made;
    }
    static Value ofPlace(Place value) {
        Value made;
        made.kind = Kind::Place;
        made.place = std::move(value);
        return made;
    }
    static Value null() {
        Value made;
        made.kind = Kind::Null;
        return made;
    }
};

enum class ElementKind { Port, Property, Attribute, Operation, Caller };

/// A port, property, attribute, operation or operation caller: the user's object, or one that an add…() made.
struct Element {
    ElementKind kind = ElementKind::Port;
    std::optional<std::string> name;    ///< not set if it is not constant
    std::string type;                   ///< C++
    clang::QualType valueType;          ///< of properties and attributes
    std::vector<clang::QualType> uses;  ///< all types of it that others see
    Place value;                        ///< place of the value of a property or an attribute
    std::string doc;
    diag::Location where;
    bool output = false;  // ports
    bool event = false;
    std::optional<model::Policy> policy;
    bool constant = false;  // attributes
    bool own = false;       // operations
    std::string result;
    std::vector<model::Argument> arguments;
    std::size_t documented = 0;  ///< number of arguments that .arg() has named
};

/// A component's main service, or one of its services.
struct Scope {
    std::string name;
    std::string doc;
    diag::Location where;
    std::vector<Place> elements;
    std::vector<Scope*> services;
};

struct Requester {
    std::string name;
    diag::Location where;
    std::vector<Place> callers;
};

/// The result of following a constructor.
struct Followed {
    model::Interface interface;
    std::string serviceName;  ///< of a service class
    std::string doc;          ///< from Service::doc()
    std::vector<model::Requirement> required;
    bool hasMore = false;  ///< there are, or may be, ports or properties that are not known
    std::optional<model::Activity> activity;
    model::InitialState initial = model::InitialState::Stopped;
    std::vector<clang::QualType> uses;  ///< types that others see
    /// Functions whose definitions would be needed, but only declarations are known.
    std::set<const clang::FunctionDecl*> unseen;
};

}  // namespace oroforge::cxx

#endif
