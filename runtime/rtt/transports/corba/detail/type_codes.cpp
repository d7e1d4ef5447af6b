// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/type_codes.hpp>

#include <rtt/transports/corba/detail/type_names.hpp>
#include <rtt/types/SequenceOps.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/VariantTable.hpp>

#include <boost/core/demangle.hpp>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <typeinfo>
#include <variant>
#include <vector>

namespace RTT::corba::detail {

namespace {

using CORBA::TypeCode;
using CORBA::TypeCode_var;
using types::Shape;
using types::TypeInfo;

/** Where a value is: one byte is an octet, except for a char or an int8 that is a value of its own. */
enum class Place { Top, Part };

class TypeCodes {
public:
    explicit TypeCodes(CORBA::ORB_ptr orb) : orb_(orb) {}

    /** Nil after a failure. */
    TypeCode_var of(const TypeInfo& type, Place place) {
        const Shape shape = type.shape();
        switch (shape.kind) {
            case Shape::Kind::Number: return number(shape.number, place);
            case Shape::Kind::Text: return orb_->create_string_tc(0);
            case Shape::Kind::Enumeration: return enumeration(type, shape);
            case Shape::Kind::Struct: return structure(type, shape);
            case Shape::Kind::Sequence: return sequence(type, shape, place);
            case Shape::Kind::Variant: return variant(type, shape);
            case Shape::Kind::Shown: return ofId(shape.shown->type(), place);
            case Shape::Kind::None: break;
        }
        return failed("the type " + type.getTypeName() + " has no shape: " + shape.reason);
    }
    const std::string& why() const { return why_; }

private:
    TypeCode_var failed(const std::string& why) {
        if (why_.empty()) why_ = why;
        return TypeCode::_nil();
    }
    TypeCode_var ofId(const char* id, Place place) {
        const TypeInfo* const type = types::Types()->getTypeById(id);
        return type ? of(*type, place) : failed("no typekit that is loaded has the type " + boost::core::demangle(id));
    }
    /** CORBA compares the pointers of its own constants, so they are shared. */
    static TypeCode_var shared(CORBA::TypeCode_ptr constant) { return TypeCode::_duplicate(constant); }

    static TypeCode_var number(Shape::Number kind, Place place) {
        const bool isTop = place == Place::Top;
        switch (kind) {
            case Shape::Number::Bool: return shared(CORBA::_tc_boolean);
            case Shape::Number::Char:
            case Shape::Number::Int8: return shared(isTop ? CORBA::_tc_char : CORBA::_tc_octet);
            case Shape::Number::UInt8: return shared(CORBA::_tc_octet);
            case Shape::Number::Int16: return shared(CORBA::_tc_short);
            case Shape::Number::UInt16: return shared(CORBA::_tc_ushort);
            case Shape::Number::Int32: return shared(CORBA::_tc_long);
            case Shape::Number::UInt32: return shared(CORBA::_tc_ulong);
            case Shape::Number::Int64: return shared(CORBA::_tc_longlong);
            case Shape::Number::UInt64: return shared(CORBA::_tc_ulonglong);
            case Shape::Number::Float32: return shared(CORBA::_tc_float);
            case Shape::Number::Float64: return shared(CORBA::_tc_double);
        }
        return TypeCode::_nil();
    }

    /** Of an enumeration without names. */
    static Shape::Number numberOf(const Shape& shape) {
        const bool isUnsigned = shape.numbers->isUnsigned;
        switch (shape.ops->size) {
            case 1: return isUnsigned ? Shape::Number::UInt8 : Shape::Number::Int8;
            case 2: return isUnsigned ? Shape::Number::UInt16 : Shape::Number::Int16;
            case 4: return isUnsigned ? Shape::Number::UInt32 : Shape::Number::Int32;
            default: return isUnsigned ? Shape::Number::UInt64 : Shape::Number::Int64;
        }
    }
    TypeCode_var enumeration(const TypeInfo& type, const Shape& shape) {
        if (shape.enumerators.empty()) return number(numberOf(shape), Place::Part);
        std::vector<std::string> names;
        for (const Shape::Enumerator& one : shape.enumerators) names.push_back(one.name);
        std::sort(names.begin(), names.end());
        CORBA::EnumMemberSeq members;
        members.length(static_cast<CORBA::ULong>(names.size()));
        for (CORBA::ULong i = 0; i != members.length(); ++i) members[i] = idlMember(names[i]).c_str();
        const IdlName name = idlNameOf(type);
        return orb_->create_enum_tc(name.id.c_str(), name.name.c_str(), members);
    }

    TypeCode_var structure(const TypeInfo& type, const Shape& shape) {
        const IdlName name = idlNameOf(type);
        const Open open(*this, name.id);
        if (!open) return orb_->create_recursive_tc(name.id.c_str());
        CORBA::StructMemberSeq members;
        for (const Shape::Field& field : shape.fields) {
            if (field.access && !field.access->store && !field.access->at) continue;  // read-only
            TypeCode_var one = ofId(field.type, Place::Part);
            if (CORBA::is_nil(one)) return one;
            if (field.count != 0) one = orb_->create_array_tc(static_cast<CORBA::ULong>(field.count), one);
            add(members, idlMember(field.name), one);
        }
        if (members.length() == 0) add(members, "nothing", CORBA::_tc_octet);
        return orb_->create_struct_tc(name.id.c_str(), name.name.c_str(), members);
    }
    static void add(CORBA::StructMemberSeq& members, std::string name, CORBA::TypeCode_ptr type) {
        const CORBA::ULong index = members.length();
        // Two names may differ in what IDL does not have.
        for (CORBA::ULong i = 0; i != index; ++i)
            if (name == members[i].name.in()) name += '_';
        members.length(index + 1);
        members[index].name = name.c_str();
        members[index].type = TypeCode::_duplicate(type);
    }

    TypeCode_var sequence(const TypeInfo& type, const Shape& shape, Place place) {
        const types::SequenceOps& ops = *shape.elements;
        const TypeInfo* const element = types::Types()->getTypeById(ops.elementType());
        TypeCode_var one = ofId(ops.elementType(), Place::Part);
        if (CORBA::is_nil(one)) return one;
        if (!ops.resize) {
            const base::DataSourceBase::shared_ptr value = type.buildValue();
            const void* const memory = value ? value->getRawConstPointer() : nullptr;
            if (!memory) return failed("the type " + type.getTypeName() + " has no default value that shows its size");
            const std::size_t size = ops.size(memory);
            return orb_->create_array_tc(static_cast<CORBA::ULong>(size), one);
        }
        one = orb_->create_sequence_tc(0, one);
        // What the original sends for its type "array".
        const bool isArray =
            place == Place::Top && type.getTypeIdName() == std::string(typeid(std::vector<double>).name());
        if (isArray) return orb_->create_alias_tc("IDL:omg.org/CORBA/DoubleSeq:1.0", "DoubleSeq", one);
        const IdlName name = idlNameOfContainer(type, *element);
        return orb_->create_alias_tc(name.id.c_str(), name.name.c_str(), one);
    }

    TypeCode_var variant(const TypeInfo& type, const Shape& shape) {
        const IdlName name = idlNameOf(type);
        const Open open(*this, name.id);
        if (!open) return orb_->create_recursive_tc(name.id.c_str());
        CORBA::UnionMemberSeq members;
        for (CORBA::ULong i = 0; i != shape.fields.size(); ++i) {
            if (std::strcmp(shape.fields[i].type, typeid(std::monostate).name()) == 0) continue;
            const TypeCode_var one = ofId(shape.fields[i].type, Place::Part);
            if (CORBA::is_nil(one)) return one;
            const CORBA::ULong index = members.length();
            members.length(index + 1);
            members[index].name = ("alternative_" + std::to_string(i)).c_str();
            members[index].label <<= i;
            members[index].type = one;
        }
        return orb_->create_union_tc(name.id.c_str(), name.name.c_str(), CORBA::_tc_ulong, members);
    }

    /** False for a type within itself. */
    class Open {
    public:
        Open(TypeCodes& codes, const std::string& id) : codes_(codes), entry_(codes.open_.insert(id)) {}
        ~Open() {
            if (entry_.second) codes_.open_.erase(entry_.first);
        }
        Open(const Open&) = delete;
        Open& operator=(const Open&) = delete;
        explicit operator bool() const { return entry_.second; }

    private:
        TypeCodes& codes_;
        const std::pair<std::set<std::string>::iterator, bool> entry_;
    };

    const CORBA::ORB_ptr orb_;
    std::set<std::string> open_;
    std::string why_;
};

}  // namespace

CORBA::TypeCode_var typeCodeOf(const TypeInfo& type, CORBA::ORB_ptr orb, std::string& why) {
    TypeCodes codes(orb);
    TypeCode_var made;
    try {
        made = codes.of(type, Place::Top);
    } catch (const CORBA::Exception& error) {
        why = std::string("CORBA has no such type: ") + error._name();
        return TypeCode::_nil();
    }
    why = codes.why();
    return made;
}

}  // namespace RTT::corba::detail
