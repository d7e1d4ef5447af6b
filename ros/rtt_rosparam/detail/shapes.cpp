// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "shapes.hpp"

#include <rtt/types/SequenceTable.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/Types.hpp>

#include <Eigen/Core>

#include <boost/core/demangle.hpp>

#include <cstring>
#include <vector>

namespace rtt_rosparam {

using RTT::types::Shape;

namespace {

struct OwnType {
    const std::type_info& type;
    const char* name;
    const RTT::types::SequenceOps& elements;
    const RTT::types::TypeOps& ops;
};

template <class Sequence>
OwnType own(const char* name) {
    return {typeid(Sequence), name, RTT::types::sequenceOps<Sequence>(), RTT::types::typeOps<Sequence>()};
}

template <class Vector>
struct VectorOps {
    typedef typename Vector::Scalar Scalar;
    static const Vector& of(const void* vector) { return *static_cast<const Vector*>(vector); }
    static Vector& of(void* vector) { return *static_cast<Vector*>(vector); }
    static constexpr RTT::types::SequenceOps table = {
        [](const void* vector) { return static_cast<std::size_t>(of(vector).size()); },
        [](const void* vector) { return static_cast<std::size_t>(of(vector).size()); },
        [](void* vector, std::size_t size) {
            of(vector).resize(static_cast<Eigen::Index>(size));
            return true;
        },
        [](void* vector, std::size_t i) -> void* { return &of(vector)[static_cast<Eigen::Index>(i)]; },
        [](const void* vector, std::size_t i, void* to) {
            *static_cast<Scalar*>(to) = of(vector)[static_cast<Eigen::Index>(i)];
        },
        [](void* vector, std::size_t i, const void* from) {
            of(vector)[static_cast<Eigen::Index>(i)] = *static_cast<const Scalar*>(from);
        },
        &RTT::types::typeRef<Scalar>,
    };
};

template <class Vector>
OwnType ownVector(const char* name) {
    return {typeid(Vector), name, VectorOps<Vector>::table, RTT::types::typeOps<Vector>()};
}

/** Sequences that work without a typekit. */
const OwnType* ownType(const char* type) {
    static const OwnType all[] = {
        own<std::vector<std::string>>("string[]"),
        own<std::vector<double>>("float64[]"),
        own<std::vector<float>>("float32[]"),
        own<std::vector<int>>("int32[]"),
        own<std::vector<unsigned>>("uint32[]"),
        own<std::vector<char>>("char[]"),
        own<std::vector<unsigned char>>("uint8[]"),
        own<std::vector<bool>>("bool[]"),
        ownVector<Eigen::VectorXd>("Eigen::VectorXd"),
        ownVector<Eigen::VectorXf>("Eigen::VectorXf"),
    };
    for (const OwnType& one : all)
        if (std::strcmp(one.type.name(), type) == 0) return &one;
    return nullptr;
}

Shape find(const char* type) {
    const RTT::types::TypeInfo* const info = RTT::types::Types()->getTypeById(type);
    Shape shape = info ? info->shape() : Shape::none("no typekit that is loaded has the type");
    if (shape) return shape;
    const OwnType* const mine = ownType(type);
    if (!mine) return shape;
    shape = Shape::ofSequence(mine->elements);
    shape.ops = &mine->ops;
    return shape;
}

}  // namespace

const Shape& Shapes::of(const char* type) {
    const auto known = known_.find(type);
    return known != known_.end() ? known->second : known_.emplace(type, find(type)).first->second;
}

std::string Shapes::nameOf(const char* type) {
    if (const RTT::types::TypeInfo* const info = RTT::types::Types()->getTypeById(type)) return info->getTypeName();
    const OwnType* const mine = ownType(type);
    return mine ? mine->name : boost::core::demangle(type);
}

bool Shapes::hasRows(const RTT::types::SequenceOps& elements) {
    if (!elements.resize || elements.at || elements.insert) return false;
    const Shape& row = of(elements.elementType());
    return row.kind == Shape::Kind::Sequence && row.elements->resize;
}

}  // namespace rtt_rosparam
