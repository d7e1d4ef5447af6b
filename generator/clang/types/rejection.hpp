// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reasons why a type cannot be described: a table has a code, words and advice for each.
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
    const char* words;               ///< follow "field 'f' of 'S' "; "{}" is replaced by the type as the user wrote it
    const char* advice;              ///< empty if there is none
    bool isMendedByAdapter = false;  ///< an adapter makes the inside of the class irrelevant
    bool isNoValue = false;          ///< the class is not meant to be copied between components
};

const Rule& ruleOf(Reason reason);

/// A field, base class or type that cannot be described.
struct Rejection {
    Reason reason = Reason::OtherType;
    std::string subject;  ///< "field 'next' of 'Node'"
    std::string type;     ///< as the user wrote it
    std::string detail;   ///< follows the words; may be empty
    clang::SourceLocation at;
    std::vector<Rejection> causes;  ///< not empty: the reason is inside the type
    bool isInBase = false;          ///< the causes are in a base class
};

/// Returns "field 'next' of 'Node' is a raw pointer 'int *'": the rule's words with the type filled in.
std::string sentence(const Rejection& rejection);

/// True if one of them says that the class is not a value, by itself or by inheritance. Types of fields do not count: a
/// field of a class requests that class.
bool isNoValue(const std::vector<Rejection>& rejections);

/// Returns the innermost first cause, or the rejection itself.
const Rejection& origin(const Rejection& rejection);

}  // namespace oroforge::cxx

#endif
