// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Options of buffers and data objects, and the storage that a port shares between its connections.
#include <rtt/Port.hpp>
#include <rtt/base/Buffer.hpp>
#include <rtt/base/DataObject.hpp>

#include <gtest/gtest.h>

using namespace RTT;

TEST(StorageMembers, OptionsTellHowManyWriteAndRead) {
    typedef base::BufferBase::Options Options;
    EXPECT_EQ(2u, Options().max_threads());
    EXPECT_FALSE(Options().multiple_writers() || Options().multiple_readers());
    const Options writers = Options().circular(true).multiple_writers(true);
    EXPECT_TRUE(writers.circular() && writers.multiple_writers() && !writers.multiple_readers());
    EXPECT_EQ(12u, writers.max_threads());
    EXPECT_EQ(22u, Options().multiple_writers(true).multiple_readers(true).max_threads());
    EXPECT_EQ(5u, Options().multiple_readers(true).max_threads(5).max_threads());
    EXPECT_EQ(12u, base::DataObjectBase::Options().multiple_readers(true).max_threads());

    ConnPolicy policy = ConnPolicy::buffer(3);
    policy.buffer_policy = PerInputPort;
    EXPECT_TRUE(Options(policy).multiple_writers());
    EXPECT_EQ(12u, Options(policy).max_threads());
    policy.buffer_policy = Shared;
    EXPECT_TRUE(base::DataObjectBase::Options(policy).multiple_readers());
    policy.max_threads = 4;
    EXPECT_EQ(4u, Options(policy).max_threads());
}

TEST(StorageMembers, ADataObjectTellsForHowManyThreadsItIs) {
    base::DataObjectLockFree<double> usual(1.0);
    EXPECT_EQ(2u, usual.MAX_THREADS);
    base::DataObjectLockFree<double> many(1.0, base::DataObjectBase::Options().max_threads(8));
    EXPECT_EQ(8u, many.MAX_THREADS);
    base::DataObject<int> derived;
    EXPECT_EQ(2u, derived.MAX_THREADS);
}

TEST(StorageMembers, TheUsualHeadersHaveTheLockedKinds) {
    base::BufferLocked<int> buffer(2, base::BufferBase::Options().multiple_writers(true));
    EXPECT_TRUE(buffer.Push(1) && buffer.Push(2) && !buffer.Push(3));
    base::DataObjectLocked<int> object(0);
    EXPECT_TRUE(object.Set(4));
    EXPECT_EQ(4, object.Get());
}

TEST(StorageMembers, APortGivesTheStorageItsConnectionsShare) {
    OutputPort<int> one("one"), other("other");
    InputPort<int> reader("reader"), second("second");
    EXPECT_FALSE(reader.getSharedBuffer());
    ConnPolicy policy = ConnPolicy::buffer(4);
    ASSERT_TRUE(one.connectTo(&second, policy));
    EXPECT_FALSE(second.getSharedBuffer()) << "this connection has a storage of its own";
    EXPECT_FALSE(one.getSharedBuffer());

    policy.buffer_policy = PerInputPort;
    ASSERT_TRUE(one.connectTo(&reader, policy) && other.connectTo(&reader, policy));
    base::ChannelElement<int>::shared_ptr shared = reader.getSharedBuffer();
    ASSERT_TRUE(shared);
    EXPECT_FALSE(one.getSharedBuffer()) << "it is the reader's";
    EXPECT_EQ(WriteSuccess, other.write(7));
    int sample = 0;
    EXPECT_EQ(NewData, shared->read(sample, true));
    EXPECT_EQ(7, sample);
    EXPECT_NE(NewData, reader.read(sample)) << "it was the only one";

    OutputPort<int> writer("writer");
    InputPort<int> third("third");
    policy.buffer_policy = PerOutputPort;
    ASSERT_TRUE(writer.connectTo(&third, policy));
    EXPECT_TRUE(writer.getSharedBuffer());
    EXPECT_FALSE(third.getSharedBuffer());
}

TEST(StorageMembers, PortsOfASharedConnectionGiveItsStorage) {
    OutputPort<int> writer("writer");
    InputPort<int> reader("reader");
    ConnPolicy policy = ConnPolicy::buffer(4);
    policy.buffer_policy = Shared;
    ASSERT_TRUE(writer.connectTo(&reader, policy));
    ASSERT_TRUE(reader.getSharedBuffer());
    EXPECT_EQ(reader.getSharedBuffer(), writer.getSharedBuffer());
    reader.disconnect();
    EXPECT_FALSE(reader.getSharedBuffer());
}
