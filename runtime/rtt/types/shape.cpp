// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where TypeInfo::shape() comes from: factories with tables, fundamental types, and members that are found in a value.
#include <rtt/types/Shape.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

namespace RTT::types {

HasShape::~HasShape() = default;

Shape Shape::none(std::string reason) {
    Shape shape;
    shape.reason = std::move(reason);
    return shape;
}

Shape Shape::ofText(const TextOps& text) {
    Shape shape;
    shape.kind = Kind::Text;
    shape.text = &text;
    return shape;
}

Shape Shape::ofStruct(const Member* members, std::size_t count) {
    Shape shape;
    shape.kind = Kind::Struct;
    shape.fields.reserve(count);
    for (const Member* member = members; member != members + count; ++member)
        shape.fields.push_back({member->name, member->offset, member->type(), member->count, member->access,
                                member->doc ? member->doc : "", member->unit ? member->unit : ""});
    return shape;
}

Shape Shape::ofSequence(const SequenceOps& elements) {
    Shape shape;
    shape.kind = Kind::Sequence;
    shape.elements = &elements;
    return shape;
}

namespace {

template <class T>
constexpr Shape::Number wholeNumber() {
    constexpr bool isSigned = std::is_signed_v<T>;
    switch (sizeof(T)) {
        case 1: return isSigned ? Shape::Number::Int8 : Shape::Number::UInt8;
        case 2: return isSigned ? Shape::Number::Int16 : Shape::Number::UInt16;
        case 4: return isSigned ? Shape::Number::Int32 : Shape::Number::UInt32;
        default: return isSigned ? Shape::Number::Int64 : Shape::Number::UInt64;
    }
}

struct Fundamental {
    const std::type_info& type;
    Shape::Number number;
};

template <class T>
Fundamental whole() {
    return {typeid(T), wholeNumber<T>()};
}

std::optional<Shape::Number> fundamental(const char* type) {
    static const Fundamental all[] = {
        {typeid(bool), Shape::Number::Bool},
        {typeid(char), Shape::Number::Char},
        {typeid(float), Shape::Number::Float32},
        {typeid(double), Shape::Number::Float64},
        whole<signed char>(),
        whole<unsigned char>(),
        whole<short>(),
        whole<unsigned short>(),
        whole<int>(),
        whole<unsigned>(),
        whole<long>(),
        whole<unsigned long>(),
        whole<long long>(),
        whole<unsigned long long>(),
        whole<char16_t>(),
        whole<char32_t>(),
        whole<wchar_t>(),
    };
    for (const Fundamental& one : all)
        if (std::strcmp(one.type.name(), type) == 0) return one.number;
    return std::nullopt;
}

using SourcePtr = base::DataSourceBase::shared_ptr;

constexpr const char* kUnknown = "its typekit does not say what it consists of";

/** Where the values of a member lie now. */
struct Place {
    const char* at = nullptr;  // null if they have no address
    const char* type = "";
    std::size_t count = 0;
};

Place placeOf(const SourcePtr& member) {
    const TypeInfo& type = *member->getTypeInfo();
    if (*type.getArrayElement() == '\0')
        return {static_cast<const char*>(member->getRawPointer()), type.getTypeIdName(), 0};
    const auto size = boost::dynamic_pointer_cast<internal::DataSource<int>>(type.getMember(member, "size"));
    const int count = size ? size->get() : 0;
    const SourcePtr first = count > 0 ? type.getMember(member, new internal::ConstantDataSource<int>(0)) : nullptr;
    if (!first) return {};
    return {static_cast<const char*>(first->getRawPointer()), type.getArrayElement(), static_cast<std::size_t>(count)};
}

/** Bytes from the start of `value` to the member, with all of which it lies within it. */
std::optional<std::size_t> offsetOf(const Place& place, const SourcePtr& value) {
    const TypeInfo* const type = Types()->getTypeById(place.type);
    const auto* const begin = static_cast<const char*>(value->getRawPointer());
    if (!place.at || !begin || !type || !type->getOps() || place.at < begin) return std::nullopt;
    const auto offset = static_cast<std::size_t>(place.at - begin);
    const std::size_t whole = value->getTypeInfo()->getOps()->size;
    const std::size_t elements = place.count ? place.count : 1;
    if (offset > whole || elements > (whole - offset) / std::max<std::size_t>(1, type->getOps()->size))
        return std::nullopt;
    return offset;
}

/** For types whose member factory is user code. Members that are at the same place in two values have a fixed one. */
Shape fromMembers(const TypeInfo& type, const MemberFactory& members) {
    const SourcePtr value = type.buildValue(), other = type.buildValue();
    const std::vector<std::string> names = members.getMemberNames();
    if (!value || !other || names.empty()) return Shape::none(kUnknown);
    Shape shape;
    shape.kind = Shape::Kind::Struct;
    for (const std::string& name : names) {
        const SourcePtr here = members.getMember(value, name), there = members.getMember(other, name);
        const Place place = here ? placeOf(here) : Place(), second = there ? placeOf(there) : Place();
        const auto offset = offsetOf(place, value);
        if (!offset || offset != offsetOf(second, other) || place.count != second.count)
            return Shape::none("its member '" + name + "' has no fixed place in a value");
        shape.fields.push_back({name, *offset, place.type, place.count, nullptr});
    }
    return shape;
}

Shape shapeOf(const TypeInfo& type) {
    const auto members = type.getMemberFactory();
    const auto compositions = type.getCompositionFactory();
    if (const auto* const own = dynamic_cast<const HasShape*>(members.get())) return own->shape();
    if (const auto* const own = dynamic_cast<const HasShape*>(compositions.get())) return own->shape();
    if (const auto number = fundamental(type.getTypeIdName())) {
        Shape shape;
        shape.kind = Shape::Kind::Number;
        shape.number = *number;
        return shape;
    }
    if (members) return fromMembers(type, *members);
    return Shape::none(kUnknown);
}

}  // namespace

Shape TypeInfo::shape() const {
    const TypeOps* const ops = getOps();
    if (!ops || !getTypeId()) return Shape::none("it has no values");
    Shape shape = shapeOf(*this);
    if (shape) shape.ops = ops;
    return shape;
}

}  // namespace RTT::types
