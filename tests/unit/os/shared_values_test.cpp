// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of user code: ReadOnlyPointer and MultiVector.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/MultiVector.hpp>
#include <rtt/extras/ReadOnlyPointer.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

using RTT::extras::MultiVector;
using RTT::extras::ReadOnlyPointer;

namespace {

struct Image {
    static std::atomic<int> alive;
    int pixel;
    explicit Image(int value) : pixel(value) { ++alive; }
    Image(const Image& other) : pixel(other.pixel) { ++alive; }
    ~Image() { --alive; }
};
std::atomic<int> Image::alive{0};

TEST(ReadOnlyPointer, LastPointerDeletes) {
    {
        ReadOnlyPointer<Image> empty;
        EXPECT_FALSE(empty.valid());
        EXPECT_EQ(nullptr, empty.get());
        EXPECT_EQ(nullptr, empty.write_access());
        ReadOnlyPointer<Image> one(new Image(7)), two(one);
        EXPECT_EQ(one.get(), two.get());
        EXPECT_EQ(7, two->pixel);
        EXPECT_EQ(7, (*two).pixel);
        empty = two;
        one.reset(nullptr);
        two.reset(new Image(8));
        EXPECT_EQ(7, empty->pixel);
        EXPECT_EQ(2, Image::alive);
        const ReadOnlyPointer<Image>& same = two;
        two = same;
        EXPECT_EQ(8, two->pixel);
    }
    EXPECT_EQ(0, Image::alive);
}

TEST(ReadOnlyPointer, SingleOwnerWritesTheValueItself) {
    Image* image = new Image(1);
    ReadOnlyPointer<Image> pointer(image);
    Image* writable = pointer.write_access();
    EXPECT_EQ(image, writable);
    EXPECT_FALSE(pointer.valid());
    writable->pixel = 2;
    pointer.reset(writable);
    EXPECT_EQ(2, pointer->pixel);
    EXPECT_EQ(1, Image::alive);
}

TEST(ReadOnlyPointer, OneOfManyWritesACopy) {
    ReadOnlyPointer<Image> pointer(new Image(1)), reader(pointer);
    EXPECT_EQ(nullptr, pointer.try_write_access());
    EXPECT_TRUE(pointer.valid());
    std::unique_ptr<Image> copy(pointer.write_access());
    EXPECT_NE(copy.get(), reader.get());
    EXPECT_FALSE(pointer.valid());
    copy->pixel = 5;
    EXPECT_EQ(1, reader->pixel);
    std::unique_ptr<Image> own(reader.try_write_access());
    ASSERT_TRUE(own);
    EXPECT_EQ(1, own->pixel);
}

TEST(ReadOnlyPointer, GoesThroughPortsWithoutCopies) {
    RTT::TaskContext writer("writer"), reader("reader");
    RTT::OutputPort<ReadOnlyPointer<Image>> out("out");
    RTT::InputPort<ReadOnlyPointer<Image>> in("in");
    writer.addPort(out);
    reader.addPort(in);
    ASSERT_TRUE(out.connectTo(&in));
    ReadOnlyPointer<Image> sent(new Image(3)), got;
    out.write(sent);
    ASSERT_EQ(RTT::NewData, in.read(got));
    EXPECT_EQ(sent.get(), got.get());
}

TEST(ReadOnlyPointer, PointersOfManyThreads) {
    {
        ReadOnlyPointer<Image> pointer(new Image(4));
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([pointer, i]() mutable {
                for (int round = 0; round < 1000; ++round) {
                    ReadOnlyPointer<Image> mine(pointer);
                    EXPECT_EQ(4, mine->pixel);
                    std::unique_ptr<Image> writable(mine.write_access());
                    writable->pixel = i;
                }
            });
        pointer.reset(nullptr);
        for (std::thread& thread : threads) thread.join();
    }
    EXPECT_EQ(0, Image::alive);
}

TEST(MultiVector, CalculatesElementByElement) {
    const double values[] = {1, 2, 4};
    MultiVector<3> a(values), b(2.0);
    EXPECT_EQ(3, int(MultiVector<3>::size));
    EXPECT_EQ(6.0, (a + b)[2]);
    EXPECT_EQ(-1.0, (a - b)[0]);
    EXPECT_EQ(4.0, (a * b)[1]);
    EXPECT_EQ(2.0, (a / b)[2]);
    EXPECT_EQ(a + a, a * 2.0);
    EXPECT_EQ(a, 2.0 * a / 2.0);
    EXPECT_EQ(-4.0, (-a)[2]);
    b = 1.5;
    b[1] = 7;
    EXPECT_NE(a, b);
    std::ostringstream text;
    text << b;
    EXPECT_EQ("[ 1.5, 7, 1.5 ]", text.str());
    MultiVector<2, int> zero;
    EXPECT_EQ(0, zero[0] + zero[1]);
}

}  // namespace
