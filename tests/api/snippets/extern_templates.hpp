// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The part of a typekit's header that keeps users from instantiating: only for headers that were included before.
#ifndef ORO_API_EXTERN_TEMPLATES_HPP
#define ORO_API_EXTERN_TEMPLATES_HPP

#include <rtt/rtt-config.h>
#include "instantiated_types.hpp"

#ifdef ORO_CHANNEL_ELEMENT_HPP
extern template class RTT::base::ChannelElement<robot::Scan>;
#endif
#ifdef CORELIB_DATASOURCE_HPP
extern template class RTT::internal::DataSource<robot::Scan>;
extern template class RTT::internal::AssignableDataSource<robot::Scan>;
#endif
#ifdef ORO_CORELIB_DATASOURCES_HPP
extern template class RTT::internal::ValueDataSource<robot::Scan>;
extern template class RTT::internal::ConstantDataSource<robot::Scan>;
extern template class RTT::internal::ReferenceDataSource<robot::Scan>;
#endif
#ifdef ORO_OUTPUT_PORT_HPP
extern template class RTT::OutputPort<robot::Scan>;
#endif
#ifdef ORO_INPUT_PORT_HPP
extern template class RTT::InputPort<robot::Scan>;
#endif
#ifdef ORO_PROPERTY_HPP
extern template class RTT::Property<robot::Scan>;
#endif
#ifdef ORO_CORELIB_ATTRIBUTE_HPP
extern template class RTT::Attribute<robot::Scan>;
extern template class RTT::Constant<robot::Scan>;
#endif

#endif
