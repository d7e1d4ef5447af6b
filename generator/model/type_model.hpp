// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What typegen knows about the types of a package: plain data, no clang types, no generated text.
#ifndef OROFORGE_GENERATOR_MODEL_TYPE_MODEL_HPP
#define OROFORGE_GENERATOR_MODEL_TYPE_MODEL_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>
#include <model/field_access.hpp>

namespace oroforge::model {

/// Of what a type needs to be seen: for each part of it the listed headers, by their numbers, any of which brings it along.
/// Empty: not known.
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
    std::string cpp;   ///< valid anywhere in C++: "double", "::demo::Point", "std::vector<::demo::Point>"
    std::string name;  ///< in the type registry: "/double", "/demo/Point", "/std/vector</demo/Point>"
    std::vector<TypeUse>
        element;       ///< what a type of the standard library is made of: elements, alternatives, the number
    std::string unit;  ///< of a Count: "ns"
};

struct Field {
    std::string name;
    TypeUse type;              ///< of one element, if the field is an array
    std::string declared;      ///< the field's C++ type, with its array bounds
    std::uint64_t count = 0;   ///< elements of `E m[N]` and `std::array<E,N> m`; 0 = not an array
    std::uint64_t offset = 0;  ///< bytes from the start of the outermost struct
    std::uint64_t place = 0;   ///< the same in bits, also of bit-fields and of what accessors hide
    std::uint64_t width = 0;   ///< bits of a bit-field
    FieldAccess access;        ///< how it is read and written
    std::string doc;           ///< comment above or behind the field, without its marks
    std::string unit;          ///< from "@unit m/s" in the comment
    std::string range;         ///< from "@range 0..5" in the comment
    std::string capacity;      ///< from "@capacity 20": for how many elements there is room
    std::string initial;       ///< default member initialiser, as it is written
    std::string also;          ///< another name of it, from an adapter
    std::string base;          ///< C++ name of the base class it comes from; empty = own field
    diag::Location where;
};

/// What scripts may call to make a value, besides what every type has.
struct Constructor {
    std::vector<TypeUse> arguments;
    std::string parameters;  ///< as a C++ function declares them: "double x, const ::KDL::Vector& p"
    std::string value;       ///< C++ of the parameters' names
};

struct Struct {
    std::string cpp;
    std::string name;
    std::uint64_t size = 0;
    std::uint64_t align = 0;
    bool assignable = true;  ///< false: a member is constant; values are read only, and no samples
    std::string make;        ///< C++ of a first value, where there is no default constructor; such are no samples
    std::string space;       ///< "::demo": the namespace in which that is to be read; empty = the global one
    std::string initial;     ///< C++ of a first value, from an adapter; empty: `T()`
    std::vector<Constructor> constructors;
    std::string doc;
    std::vector<Field> fields;  ///< fields of base classes first
    Homes homes;
    diag::Location where;
};

/// A class whose elements an adapter says how to reach. Texts are what the adapter writes behind the object.
struct Adapted {
    std::string cpp;
    std::string name;
    std::uint64_t size = 0;
    std::uint64_t align = 0;
    std::string doc;
    TypeUse element;
    TypeUse row;          ///< of a matrix: what its rows are seen as
    std::string count;    ///< how many elements, in digits or what says it; of a matrix, rows
    std::string columns;  ///< of a matrix, the same
    std::string resize;   ///< to `size`, or `rows` and `columns`; empty: the size is fixed
    FieldAccess access;   ///< to the element of `index`, or `row` and `column`
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

/// Another name of a type.
struct Alias {
    std::string name;  ///< in the type registry
    std::string of;    ///< the type's first name there
    diag::Location where;
};

/// A header to describe: its name as the user gave it and as generated code includes it.
struct Header {
    std::string path;
    std::string include;
    std::vector<std::size_t> before = {};  ///< those listed before it that have to be included first, by their numbers
    std::size_t pieces = 1;                ///< how many source files its types are dealt out to
};

struct TypeModel {
    std::vector<Header> headers;
    std::vector<Struct> structs;
    std::vector<Enum> enums;
    std::vector<Adapted> adapted;
    std::vector<Alias> aliases;
    std::vector<TypeUse> library;    ///< each type of the standard library that a field reaches, inner ones included
    std::vector<TypeUse> arrays;     ///< the element type of each array
    std::vector<diag::Note> notes;   ///< for those who want to know more
    std::vector<std::string> files;  ///< every file that was read, for dependency files
};

/// The model as JSON text (`--dump=model`); `files` is left out, for it depends on the machine.
std::string dump(const TypeModel& model);

}  // namespace oroforge::model

#endif
