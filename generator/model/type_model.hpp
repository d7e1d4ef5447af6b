// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What typegen knows of a package's types: plain data, no clang types, no generated text.
#ifndef OROFORGE_GENERATOR_MODEL_TYPE_MODEL_HPP
#define OROFORGE_GENERATOR_MODEL_TYPE_MODEL_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <model/field_access.hpp>

namespace oroforge::model {

/// For each part that a type needs: numbers of the listed headers that each provide it. Empty if not known.
using Homes = std::vector<std::vector<std::size_t>>;

enum class TypeKind {
    Scalar,
    String,
    Enum,
    Struct,
    Sequence,  ///< std::vector, std::deque, std::array …: elements by index
    Linked,    ///< std::list, std::forward_list
    Set,
    Map,
    Optional,
    Variant,
    Pair,
    Tuple,
    Complex,
    Character,   ///< wchar_t, char16_t, char32_t, std::byte: shown as a number
    LongDouble,  ///< shown as text
    Nothing,     ///< std::monostate
    Count,       ///< std::chrono: a duration or a time point, shown as its count
    Bits         ///< std::bitset, shown as its digits
};

/// The type of a field, of a sequence's elements or of an array's elements.
struct TypeUse {
    TypeKind kind = TypeKind::Scalar;
    std::string cpp;               ///< valid anywhere in C++: "double", "::demo::Point", "std::vector<::demo::Point>"
    std::string name;              ///< in the type registry: "/double", "/demo/Point", "/std/vector</demo/Point>"
    std::vector<TypeUse> element;  ///< parts of a library type: elements, alternatives, the number
    std::string unit;              ///< "ns" of a Count
    std::string array = {};        ///< registry name of arrays of it; empty: its name and "[]"
};

inline std::string arrayName(const TypeUse& element) {
    return element.array.empty() ? element.name + "[]" : element.array;
}

/// A constant of C++ that is true if the compiler sees the type that the generator read. For generators that do not
/// know sizes and offsets, which the compiler then computes.
struct Proof {
    std::string condition;
    std::string otherwise;  ///< what the compiler says if it is false
};

struct Field {
    std::string name;
    TypeUse type;              ///< of one element, if the field is an array
    std::string declared;      ///< the field's C++ type, with its array bounds
    std::uint64_t count = 0;   ///< elements of `E m[N]` and `std::array<E,N> m`; 0 = not an array
    std::uint64_t offset = 0;  ///< bytes from the start of the outermost struct
    std::uint64_t place = 0;   ///< the same in bits; bit-fields and hidden members have it, too
    std::uint64_t width = 0;   ///< bits of a bit-field
    FieldAccess access;        ///< how it is read and written
    std::string doc;           ///< comment above or after the field, without comment marks
    std::string unit;          ///< from "@unit m/s" in the comment
    std::string range;         ///< from "@range 0..5" in the comment
    std::string capacity;      ///< from "@capacity 20": number of elements that it has room for
    std::string initial;       ///< default member initialiser, as written
    std::string also;          ///< another name, from an adapter
    std::string base;          ///< C++ name of the base class that declares it; empty = own field
    diag::Location where;
};

/// A constructor that scripts may call, besides those that every type has.
struct Constructor {
    std::vector<TypeUse> arguments;
    std::string parameters;  ///< declarations of C++ parameters: "double x, const ::KDL::Vector& p"
    std::string value;       ///< C++ that makes the value from the parameters
};

struct Struct {
    std::string cpp;
    std::string name;
    std::uint64_t size = 0;
    std::uint64_t align = 0;
    bool assignable = true;  ///< false: a member is constant; values are read-only, and cannot be samples
    std::string make;        ///< C++ of a first value, if there is no default constructor: then no samples
    std::string space;       ///< "::demo": the namespace in which `make` is looked up; empty = the global one
    std::string initial;     ///< C++ of a first value, from an adapter; empty: `T()`
    std::vector<Constructor> constructors;
    std::string doc;
    std::string message = {};   ///< from "@ros geometry_msgs/Pose" in the comment
    std::vector<Field> fields;  ///< fields of base classes first
    Homes homes;
    Proof proof;            ///< no condition: `size`, `align` and offsets are compared
    bool instances = true;  ///< false: users of the typekit make their own instances of templates
    diag::Location where;
};

/// A class whose elements are reached as an adapter says. Its texts are C++ that follows the object.
struct Adapted {
    std::string cpp;
    std::string name;
    std::uint64_t size = 0;
    std::uint64_t align = 0;
    std::string doc;
    TypeUse element;
    TypeUse row;          ///< of a matrix: the type that shows a row
    std::string count;    ///< number of elements, as digits or as C++ that returns it; rows of a matrix
    std::string columns;  ///< the same for columns of a matrix
    std::string resize;   ///< to `size`, or `rows` and `columns`; empty: fixed size
    FieldAccess access;   ///< to the element at `index`, or at `row` and `column`
    std::string initial;  ///< C++ of a first value; empty: `T()`
    std::vector<Constructor> constructors;
    Homes homes;
    diag::Location where;
};

struct Enumerator {
    std::string name;
    std::string cpp;    ///< "::demo::Mode::Idle"
    std::string value;  ///< decimal, exact for every underlying type
    std::string doc;
    diag::Location where;
};

struct Enum {
    std::string cpp;
    std::string name;
    std::string underlying;
    std::uint64_t size = 0;
    std::string doc;
    std::vector<Enumerator> values;
    Homes homes;
    diag::Location where;
};

struct Alias {
    std::string name;  ///< in the type registry
    std::string of;    ///< the first name of the type
    diag::Location where;
};

/// A listed header: its path as the user gave it, and its name in #include lines of generated code.
struct Header {
    std::string path;
    std::string include;
    std::vector<std::size_t> before = {};  ///< numbers of listed headers that must be included first
    std::size_t pieces = 1;                ///< number of source files for its types
    std::vector<std::string> more = {};    ///< names of further #include lines: one header stands for all of them
};

/// A type whose encoded values are messages of ROS.
struct Message {
    std::string type;        ///< in the type registry
    std::string name;        ///< "geometry_msgs/Pose"
    std::string md5;         ///< 32 hexadecimal digits
    std::string definition;  ///< text of the .msg file, followed by those of the messages in it
};

struct TypeModel {
    std::vector<Header> headers;
    std::vector<Struct> structs;
    std::vector<Enum> enums;
    std::vector<Adapted> adapted;
    std::vector<Alias> aliases;
    std::vector<TypeUse> library;  ///< each type of the standard library in a field, and its parts
    std::vector<TypeUse> arrays;   ///< the element type of each array
    std::vector<Message> messages;
    std::vector<diag::Note> notes;   ///< details for --verbose
    std::vector<std::string> files;  ///< every file that was read, for depfiles
};

/// Returns the model as JSON text (`--dump=model`), without `files`, which depend on the machine.
std::string dump(const TypeModel& model);

}  // namespace oroforge::model

#endif
