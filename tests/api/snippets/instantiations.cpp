// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The file of a typekit that instantiates everything, for all kinds of types; nothing but the headers of the templates.
#include <rtt/Attribute.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/base/ChannelElement.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/typekit/StdStringTypeInfo.hpp>
#include <rtt/typekit/StdTypeInfo.hpp>
#include <rtt/types/CArrayTypeInfo.hpp>
#include <rtt/types/PrimitiveSequenceTypeInfo.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/carray.hpp>
#include "instantiated_types.hpp"

#include <gtest/gtest.h>

#define INSTANTIATE(T)                                     \
    template struct RTT::internal::DataSourceTypeInfo<T>;  \
    template class RTT::internal::DataSource<T>;           \
    template class RTT::internal::AssignableDataSource<T>; \
    template class RTT::internal::AssignCommand<T>;        \
    template class RTT::internal::ValueDataSource<T>;      \
    template class RTT::internal::ConstantDataSource<T>;   \
    template class RTT::internal::ReferenceDataSource<T>;  \
    template class RTT::base::ChannelElement<T>;           \
    template class RTT::OutputPort<T>;                     \
    template class RTT::InputPort<T>;                      \
    template class RTT::Property<T>;                       \
    template class RTT::Attribute<T>;                      \
    template class RTT::Constant<T>;

INSTANTIATE(robot::Scan)
INSTANTIATE(robot::Scans)
INSTANTIATE(robot::Mode)
INSTANTIATE(robot::Covariance)
INSTANTIATE(robot::PosePtr)
INSTANTIATE(robot::RawPose)
INSTANTIATE(std::vector<std::string>)
INSTANTIATE(std::vector<bool>)
INSTANTIATE(long double)

template class RTT::types::PrimitiveSequenceTypeInfo<robot::Scans>;
template class RTT::types::CArrayTypeInfo<RTT::types::carray<robot::Scan>>;
template class RTT::types::StdTypeInfo<long double>;
template class RTT::types::StdBasicStringTypeInfo<std::string>;

TEST(UserCode, InstantiatesEverythingForATypeWithoutOperators) {
    robot::Scans scans(2);
    RTT::internal::ReferenceDataSource<robot::Scans>::shared_ptr source(
        new RTT::internal::ReferenceDataSource<robot::Scans>(scans));
    source->set().resize(3);
    EXPECT_EQ(scans.size(), 3u);
    EXPECT_EQ(RTT::internal::DataSourceTypeInfo<robot::Scans>::getType(), "unknown_t");

    RTT::internal::ValueDataSource<robot::Mode>::shared_ptr mode(
        new RTT::internal::ValueDataSource<robot::Mode>(robot::Idle));
    RTT::internal::AssignCommand<robot::Mode> assign(mode.get(),
                                                     new RTT::internal::ConstantDataSource<robot::Mode>(robot::Moving));
    assign.readArguments();
    EXPECT_TRUE(assign.execute());
    EXPECT_EQ(mode->get(), robot::Moving);
}
