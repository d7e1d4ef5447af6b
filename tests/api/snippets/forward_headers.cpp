// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Headers that only declare, and headers under other names: they agree with what is defined.
#include <rtt/rtt-fwd.hpp>
#include <rtt/extras/rtt-extras-fwd.hpp>
#include <rtt/internal/rtt-internal-fwd.hpp>
#include <rtt/marsh/rtt-marsh-fwd.hpp>
#include <rtt/os/rtt-os-fwd.hpp>
#include <rtt/plugin/rtt-plugin-fwd.hpp>
#include <rtt/types/rtt-types-fwd.hpp>

#include <rtt/ArgumentDescription.hpp>
#include <rtt/RTT.hpp>
#include <rtt/SlaveActivity.hpp>
#include <rtt/TimeService.hpp>
#include <rtt/internal/AssignCommand.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <rtt/internal/PartDataSource.hpp>
#include <rtt/marsh/Marshalling.hpp>
#include <rtt/os/Atomic.hpp>
#include <rtt/os/Time.hpp>
#include <rtt/os/oro_allocator.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/typekit/StdVectorTypeInfo.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/SequenceTypeInfoBase.hpp>
#include <rtt/types/carray.hpp>

#include <gtest/gtest.h>

TEST(UserCode, FindsHeadersUnderOtherNames) {
    EXPECT_GT(RTT::TimeService::Instance()->getTicks(), 0);
    RTT::extras::SlaveActivity activity(0.5);
    const RTT::Seconds period = activity.getPeriod();
    EXPECT_EQ(period, 0.5);
    RTT::ArgumentDescription argument("a", "first", "int");
    EXPECT_EQ(argument.type, "int");
    RTT::types::StdVectorTypeInfo generator("snippet_array");
    RTT::types::SequenceTypeInfoBase<std::vector<double>>* sequence = &generator;
    EXPECT_TRUE(sequence);
}
