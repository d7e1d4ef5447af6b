// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPES_SHAPE_HPP
#define ORO_TYPES_SHAPE_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace RTT {
namespace types {

struct EnumOps;
struct Member;
struct SequenceOps;
struct ShownAs;
struct TypeOps;
struct VariantOps;

/** Access to the letters of a text of an erased type. */
struct TextOps {
    std::string_view (*get)(const void* text);
    void (*set)(void* text, const char* letters, std::size_t size);
};

/** For std::basic_string<char> with any allocator. */
template <class Text>
const TextOps& textOps() {
    static constexpr TextOps table = {
        [](const void* text) {
            const Text& all = *static_cast<const Text*>(text);
            return std::string_view(all.data(), all.size());
        },
        [](void* text, const char* letters, std::size_t size) { static_cast<Text*>(text)->assign(letters, size); },
    };
    return table;
}

/**
 * What the values of a type consist of, for code that reads and writes them without knowing the C++ type: encodings,
 * tools. What it points to lives as long as the process. Types are named by type_info::name(); see
 * TypeInfoRepository::getTypeById().
 */
struct RTT_API Shape {
    enum class Kind {
        None,         ///< unknown, see `reason`
        Number,       ///< bool and char included: `number`
        Text,         ///< `text`
        Enumeration,  ///< `numbers` and `enumerators`
        Struct,       ///< `fields`
        Sequence,     ///< `elements`: containers and arrays of any kind, std::optional, matrices by rows
        Variant,      ///< `variant`, and `fields` for its alternatives
        Shown         ///< a value of another type stands for it: `shown`
    };
    enum class Number { Bool, Char, Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };
    /** A part of a struct, or an alternative of a variant. */
    struct Field {
        std::string name;
        std::size_t offset;         ///< bytes from the start of the struct
        const char* type;           ///< of the elements if it is an array
        std::size_t count;          ///< 0 if it is not an array
        const SequenceOps* access;  ///< for a field without an offset, see memberAccess()
        const char* doc = "";
        const char* unit = "";
    };
    struct Enumerator {
        std::string name;
        long long value;
        const char* doc = "";
    };

    Kind kind = Kind::None;
    std::string reason;            ///< why there is none, a sentence without its end
    const TypeOps* ops = nullptr;  ///< null if there is none
    Number number = Number::Bool;
    const TextOps* text = nullptr;
    const EnumOps* numbers = nullptr;
    std::vector<Enumerator> enumerators;
    std::vector<Field> fields;
    const SequenceOps* elements = nullptr;
    const VariantOps* variant = nullptr;
    const ShownAs* shown = nullptr;

    explicit operator bool() const { return kind != Kind::None; }
    static Shape none(std::string reason);
    static Shape ofText(const TextOps& text);
    static Shape ofStruct(const Member* members, std::size_t count);
    static Shape ofSequence(const SequenceOps& elements);
};

/** An additional interface of the member factory or the composition factory of a type. */
class RTT_API HasShape {
public:
    virtual ~HasShape();
    /** TypeInfo::shape() adds `ops`. */
    virtual Shape shape() const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
