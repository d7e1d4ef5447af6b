// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "rejection.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace oroforge::cxx {

namespace {

constexpr Rule kRules[] = {
    {Reason::RawPointer, "TK010", "is a raw pointer '{}', which has no value to copy between components",
     "store the value itself, or a std::vector of values", true},
    {Reason::CString, "TK010", "is a raw pointer '{}', which has no value to copy between components",
     "use std::string", true},
    {Reason::Reference, "TK011", "is a reference '{}', which has no value of its own", "store the value itself", true},
    {Reason::Callable, "TK012", "is a callable '{}', which is not data", "offer an operation of a component instead",
     true},
    {Reason::PrivateMember, "TK013", "is not public",
     "make it public, give it accessors (width() and setWidth() for width_), or leave it out with [[oro::skip]]", true,
     true},
    {Reason::Union, "TK014", "is a union; which of its members is meant cannot be known",
     "use std::variant or a struct; [[oro::bytes]] before the name of the union shows its bytes", true},
    {Reason::RestrictedElement, "TK015", "is of type '{}', whose elements cannot be assigned or made without arguments",
     "give the element type a default constructor and no const members, or use a plain field of it"},
    {Reason::ConstMember, "TK016", "is a constant array '{}', which cannot be copied",
     "use a constant std::array, or make it static constexpr"},
    {Reason::VolatileMember, "TK017", "is volatile ('{}'), expected a plain value", "remove volatile", true},
    {Reason::UnsuitedAttribute, "TK018", "has an attribute that does not suit its type '{}'",
     "[[oro::text]] is for arrays of char, [[oro::bytes]] for unions, [[oro::by_value]] for smart pointers, "
     "[[oro::capacity(n)]] for strings and containers"},
    {Reason::UnboundedArray, "TK019", "is an array '{}' without elements, that is unbounded storage",
     "give it a fixed size, or use std::vector", true},
    {Reason::Polymorphic, "TK020", "has virtual functions: its objects have an identity and are not values",
     "move the data into a plain struct and let the class hold it; [[oro::skip]] before its name leaves the class out",
     true, true},
    {Reason::HiddenBase, "TK021", "is not public", "inherit publicly, or make the base class a member", true, true},
    {Reason::VirtualBase, "TK022", "is virtual, so its fields have no fixed place",
     "inherit without virtual, or make the base class a member", true},
    {Reason::SameName, "TK023", "has the same name as another field that is inherited", "rename one of them"},
    {Reason::NoDefaultConstructor, "TK024", "has no public default constructor, which ports and properties need",
     "add a public constructor without arguments; or tell how a value is made, by [[oro::make(\"T(0)\")]] before the "
     "name of "
     "the type: it is then good for properties, but not for ports"},
    {Reason::NotCopyable, "TK025", "lacks a public copy constructor, copy assignment or destructor, which samples need",
     "allow copy construction, copy assignment and destruction"},
    {Reason::Misaligned, "TK026", "is packed to an address that does not suit '{}'",
     "order the fields by size instead of packing them"},
    {Reason::WideBitField, "TK033", "is wider than its type '{}'", "use several bit-fields, or a larger type"},
    {Reason::Unnamed, "TK028", "has a type without a name outside of its function, '{}'", "declare the type outside"},
    {Reason::InternalLinkage, "TK029", "lies in an unnamed namespace: each file would have its own type",
     "move it into a named namespace"},
    {Reason::HiddenType, "TK030", "has the type '{}', whose name is not public", "make the nested type public", true},
    {Reason::WideScalar, "TK031", "is of type '{}', an extension of the compiler",
     "use a sized integer such as std::int64_t, or a struct of two", true},
    {Reason::CustomAllocator, "TK034", "is '{}' with an allocator of its own", "use the standard allocator"},
    {Reason::View, "TK036", "is a non-owning view '{}'; what it looks at may be gone when a sample is read",
     "use std::string or std::vector", true},
    {Reason::OtherString, "TK037", "is a string '{}', expected std::string", "use std::string with UTF-8 text"},
    {Reason::SmartPointer, "TK038", "is a smart pointer '{}': samples would share or lose what it points to",
     "store the value itself, or a std::vector of values; [[oro::by_value]] shows what it points to, or nothing", true},
    {Reason::Synchronisation, "TK039", "is '{}', which synchronises threads and is no value",
     "keep it in the component; ports and operations are thread-safe already"},
    {Reason::Atomic, "TK039", "is '{}', so the struct cannot be copied",
     "use the plain number, as ports and operations are thread-safe already; or write a copy constructor and an "
     "assignment "
     "that load and store it"},
    {Reason::OtherSequence, "TK042", "is '{}', whose elements cannot be reached", "use std::vector or std::deque",
     true},
    {Reason::AnyType, "TK044", "is '{}', which may hold a value of any type",
     "use std::variant of the types that are meant", true},
    {Reason::SameAlternative, "TK045", "is '{}', where two alternatives have the same type",
     "wrap one of them in a struct"},
    {Reason::HashedKey, "TK046", "is '{}', whose keys have no order to write them in", "use std::map or std::set"},
    {Reason::StandardBase, "TK047", "is a class of the standard library, which brings no fields", "make it a member",
     true},
    {Reason::OtherStandard, "TK047", "is of the standard library type '{}', which typekits do not hold",
     "use numbers, std::string, containers, std::optional, std::variant, std::chrono and structs of these", true},
    {Reason::NeverDefined, "TK048", "has the type '{}', which is declared but never defined",
     "include the header that defines it"},
    {Reason::TemplateArgument, "TK049", "has the type '{}', a template instance that cannot be named",
     "use types, integers and enumerators as template arguments"},
    {Reason::SharedName, "TK051", "shares its name with a function, variable or field, which hides it",
     "rename one of them, or put the type into a namespace"},
    {Reason::OtherType, "TK050", "has the type '{}', expected a number, enum, string, struct, container or array", ""},
};

}  // namespace

const Rule& ruleOf(Reason reason) {
    for (const Rule& rule : kRules) {
        if (rule.reason == reason) return rule;
    }
    assert(false && "reason without a rule");
    return kRules[0];
}

std::string sentence(const Rejection& rejection) {
    std::string words = ruleOf(rejection.reason).words;
    const std::size_t hole = words.find("{}");
    if (hole != std::string::npos) words.replace(hole, std::strlen("{}"), rejection.type);
    return rejection.subject + " " + words + rejection.detail;
}

bool isNoValue(const std::vector<Rejection>& rejections) {
    return std::any_of(rejections.begin(), rejections.end(), [](const Rejection& one) {
        return one.causes.empty() ? ruleOf(one.reason).isNoValue : one.isInBase && isNoValue(one.causes);
    });
}

const Rejection& origin(const Rejection& rejection) {
    return rejection.causes.empty() ? rejection : origin(rejection.causes.front());
}

}  // namespace oroforge::cxx
