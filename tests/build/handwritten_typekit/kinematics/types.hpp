// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the typekit says of the types, for itself and for components: how they are serialized, and which templates it holds.
#ifndef KINEMATICS_TYPEKIT_TYPES_HPP
#define KINEMATICS_TYPEKIT_TYPES_HPP

#include "kinematics.hpp"

#include <boost/serialization/array.hpp>
#include <boost/serialization/base_object.hpp>
#include <boost/serialization/nvp.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>

namespace boost {
namespace serialization {
template <class Archive>
void serialize(Archive& a, kinematics::Frame& f, unsigned int) {
    a& make_nvp("p", f.p);
    a& make_nvp("M", f.M);
}
template <class Archive>
void serialize(Archive& a, kinematics::Rot& r, unsigned int) {
    a& make_nvp("data", make_array(r.data, 9));
}
template <class Archive>
void serialize(Archive& a, kinematics::Named& n, unsigned int) {
    a& make_nvp("name", n.name);
    a& BOOST_SERIALIZATION_NVP(n.id);
}
template <class Archive>
void serialize(Archive& a, kinematics::Segment& s, unsigned int) {
    a& base_object<kinematics::Named>(s);
    a& make_nvp("tip", s.tip);
    a& make_nvp("joint", s.joint);
    a& make_nvp("limits", s.limits);
    a& make_nvp("inertia", s.inertia);
    a& make_nvp("tags", s.tags);
}
}  // namespace serialization
}  // namespace boost

#define KINEMATICS_EXTERN(T)                                      \
    extern template class RTT::internal::DataSource<T>;           \
    extern template class RTT::internal::AssignableDataSource<T>; \
    extern template class RTT::internal::ValueDataSource<T>;      \
    extern template class RTT::internal::ConstantDataSource<T>;   \
    extern template class RTT::internal::ReferenceDataSource<T>;  \
    extern template class RTT::OutputPort<T>;                     \
    extern template class RTT::InputPort<T>;                      \
    extern template class RTT::Property<T>;                       \
    extern template class RTT::Attribute<T>;

KINEMATICS_EXTERN(kinematics::Vec)
KINEMATICS_EXTERN(kinematics::Frame)
KINEMATICS_EXTERN(kinematics::Segment)

#endif
