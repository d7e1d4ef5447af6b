// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Why a type cannot be described: one code per reason, with its words and its advice in one table.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_REJECTION_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_REJECTION_HPP

#include <string>
#include <vector>

#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

enum class Reason {
    RawPointer,
    CString,
    Reference,
    Callable,
    PrivateMember,
    Union,
    ConstMember,
    RestrictedElement,
    VolatileMember,
    UnboundedArray,
    UnsuitedAttribute,
    Polymorphic,
    HiddenBase,
    VirtualBase,
    SameName,
    NoDefaultConstructor,
    NotCopyable,
    Misaligned,
    WideBitField,
    Unnamed,
    InternalLinkage,
    HiddenType,
    WideScalar,
    CustomAllocator,
    View,
    OtherString,
    SmartPointer,
    Synchronisation,
    Atomic,
    OtherSequence,
    AnyType,
    SameAlternative,
    HashedKey,
    StandardBase,
    OtherStandard,
    NeverDefined,
    TemplateArgument,
    SharedName,
    OtherType,
};

struct Rule {
    Reason reason;
    const char* code;
    const char* words;               ///< follow "field 'f' of 'S' "; "{}" stands for the type as the user wrote it
    const char* advice;              ///< empty if there is none
    bool isMendedByAdapter = false;  ///< what lies inside of a class with an adapter does not matter
    bool isNoValue = false;          ///< the class is not meant to be copied from component to component
};

const Rule& ruleOf(Reason reason);

/// A field, base class or type that cannot be described.
struct Rejection {
    Reason reason = Reason::OtherType;
    std::string subject;  ///< "field 'next' of 'Node'"
    std::string type;     ///< as the user wrote it
    std::string detail;   ///< follows the words; empty if they say all
    clang::SourceLocation at;
    std::vector<Rejection> causes;  ///< not empty: the reason lies inside the type
    bool isInBase = false;          ///< the causes are those of a base class
};

/// "field 'next' of 'Node' is a raw pointer 'int *'": the words of the rule filled in.
std::string sentence(const Rejection& rejection);

/// Whether one of them says that the class is no value at all, by itself or by what it inherits. What its fields consist of
/// does not count: whoever makes a field of a class asks for it.
bool isNoValue(const std::vector<Rejection>& rejections);

/// The innermost first cause, or the rejection itself.
const Rejection& origin(const Rejection& rejection);

}  // namespace oroforge::cxx

#endif
