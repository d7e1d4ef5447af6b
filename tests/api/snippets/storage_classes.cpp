// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/Buffer.hpp>
#include <rtt/base/DataObject.hpp>

#include <gtest/gtest.h>

TEST(UserCode, UsesTheUsualDataObjectAndBuffer) {
    RTT::base::DataObject<double> object;
    RTT::base::DataObjectInterface<double>& data = object;
    data.Set(1.5);
    EXPECT_EQ(data.Get(), 1.5);
    RTT::base::Buffer<double> buffer(2, 0.0);
    RTT::base::BufferInterface<double>& fifo = buffer;
    EXPECT_TRUE(fifo.Push(1.5) && fifo.Push(2.5) && !fifo.Push(3.5));
    double value = 0;
    EXPECT_TRUE(fifo.Pop(value) == RTT::NewData && value == 1.5);
}
