// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The user's classes: the bytes of each part in their files. Plain data, filled in by generator/clang/update.
#ifndef OROFORGE_GENERATOR_MODEL_USER_CODE_HPP
#define OROFORGE_GENERATOR_MODEL_USER_CODE_HPP

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>

namespace oroforge::model {

/// Bytes [begin, end) of a file. Empty (0, 0) if there is no such part.
struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;

    bool empty() const { return begin == end; }
    bool holds(std::size_t at) const { return begin <= at && at < end; }
    bool holds(const Span& other) const { return begin <= other.begin && other.end <= end; }
};

inline bool operator==(const Span& a, const Span& b) { return a.begin == b.begin && a.end == b.end; }
inline bool operator<(const Span& a, const Span& b) { return a.begin != b.begin ? a.begin < b.begin : a.end < b.end; }

/// A type and a name, as written.
struct TypedName {
    std::string type;
    std::string name;
};

inline bool operator==(const TypedName& a, const TypedName& b) { return a.type == b.type && a.name == b.name; }

/// The signature of a method, as written.
struct Signature {
    std::string returns = "void";
    std::vector<TypedName> arguments;
};

inline bool operator==(const Signature& a, const Signature& b) {
    return a.returns == b.returns && a.arguments == b.arguments;
}

/// The types of a signature after the compiler resolved aliases and namespaces; all empty if it could not.
struct CanonicalSignature {
    std::string returns;
    std::vector<std::string> arguments;

    bool known() const { return !returns.empty(); }
};

inline bool operator==(const CanonicalSignature& a, const CanonicalSignature& b) {
    return a.returns == b.returns && a.arguments == b.arguments;
}

struct UserParameter {
    std::string name;      ///< empty if it has none
    Span whole;            ///< from the type to the end of the name or default value
    Span type;             ///< empty if type and name are intertwined, as in "int a[3]", or come from a macro
    bool isMacro = false;  ///< a macro supplies some of it
};

enum class FunctionKind { Method, Constructor, Destructor };
enum class Access { Public, Protected, Private };

/// A declaration or definition of a member function.
struct UserFunction {
    std::string name;
    FunctionKind kind = FunctionKind::Method;
    Access access = Access::Public;
    bool isTemplate = false;
    bool isMacro = false;  ///< declared by a macro, so no part of it can be edited
    bool isOther = false;  ///< const, static, volatile or with &: it cannot be an operation or hook of the manifest
    bool saysVirtual = false;
    bool saysOverride = false;  ///< or final
    bool inClass = false;       ///< in the body of the class
    bool isDefinition = false;

    std::string file;
    diag::Location where;  ///< of the name
    Span whole;            ///< from the first word to the ';' or '}', which is included
    Span returns;          ///< empty if the type cannot be told from other words
    Span qualifier;        ///< "tank::Plant::" of a definition outside the class
    Span nameSpan;
    Span brackets;  ///< text between '(' and ')'
    std::vector<UserParameter> parameters;
    Span body;          ///< with its braces
    Span scope;         ///< text between the braces of the enclosing namespace; the whole file if there is none
    std::string space;  ///< that namespace, "" if there is none
    CanonicalSignature types;
};

/// A data member.
struct UserField {
    std::string name;
    std::string file;
    diag::Location where;
    Span whole;             ///< with the ';'
    Span type;              ///< empty if it cannot be replaced: several names, a macro, "int a[3]"
    Span portWord;          ///< "InputPort" in its type; empty if it cannot be replaced
    std::string canonical;  ///< type after the compiler resolved it
    std::string portClass;  ///< "InputPort" or "OutputPort"; empty if it is not a port
    std::string literal;    ///< first string in its initialiser, in the class or in a constructor
};

/// .doc("The level") or .arg("hard", "All of it") after a registration.
struct UserText {
    std::string argument;  ///< "hard"; empty for .doc()
    std::string words;     ///< "All of it"
    Span call;             ///< from the '.' to the ')'
    Span literal;          ///< with its quotes; empty if it is not a plain string
};

/// A call such as this->addPort("level", level_) in a method.
struct UserRegistration {
    std::string verb;     ///< "addPort"
    std::string literal;  ///< first argument, if it is a string
    std::string member;   ///< the data member among the arguments
    std::string service;  ///< "gripper.motion" of provides("gripper")->provides("motion")
    std::string thread;   ///< "OwnThread" of an operation, if given
    std::string file;
    diag::Location where;
    Span statement;  ///< with the ';'
    Span receiver;   ///< text before the verb: "this->", "ports()->" or nothing
    Span verbSpan;
    Span threadSpan;
    std::size_t arguments = 0;
    std::size_t callEnd = 0;      ///< after the ')' of the call itself
    std::vector<UserText> texts;  ///< in their order
    bool textsKnown = false;      ///< nothing but calls of doc() and arg() follows
    bool knowsService = true;     ///< false if it may be any service, as of a variable
    bool isNested = false;        ///< not directly in a constructor: runs conditionally or several times
};

/// "public:" and the like.
struct AccessLabel {
    Access access = Access::Public;
    Span span;
};

struct UserClass {
    std::string name;  ///< qualified
    std::string file;
    diag::Location where;
    bool isMacro = false;
    bool hasGeneratedBase = false;  ///< derives from the class generated from its manifest
    bool isStruct = false;
    Span whole;  ///< from "class" to its '}'
    Span body;   ///< between the braces
    std::vector<AccessLabel> labels;
    std::vector<UserFunction> functions;  ///< by file and place
    std::vector<UserField> fields;
    std::vector<UserRegistration> registrations;
};

/// The lines between #if and #endif, and the lines of them that the compiler skipped.
struct Conditionals {
    std::vector<Span> blocks;   ///< whole lines
    std::vector<Span> skipped;  ///< whole lines
};

struct UserCode {
    std::vector<UserClass> classes;
    std::map<std::string, Conditionals> conditionals;  ///< by file
    std::map<std::string, std::string> texts;          ///< contents of the files that were read
};

}  // namespace oroforge::model

#endif
