// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Fields that are marked as the time of their value.
#include "encoded_types.hpp"

#include <rtt/encoding/Stamp.hpp>
#include <rtt/types/StructTable.hpp>

#include <gmock/gmock.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <typeinfo>

using encoded::EncodedTypes;
using RTT::encoding::Stamp;
using testing::HasSubstr;

namespace stamp_test {

using RTT::types::Member;
using RTT::types::typeRef;

struct Time {
    int sec = 0;
    unsigned nanosec = 0;
};
constexpr Member kTime[] = {{"sec", offsetof(Time, sec), &typeRef<int>, 0, "", ""},
                            {"nanosec", offsetof(Time, nanosec), &typeRef<unsigned>, 0, "", ""}};

struct Header {
    double other = 0;
    Time stamp;
};
constexpr Member kHeader[] = {{"other", offsetof(Header, other), &typeRef<double>, 0, "Not @stamped.", ""},
                              {"stamp", offsetof(Header, stamp), &typeRef<Time>, 0, "When. @stamp", ""}};

struct Image {
    Header header;
    double size = 0;
};
constexpr Member kImage[] = {{"header", offsetof(Image, header), &typeRef<Header>, 0, "", ""},
                             {"size", offsetof(Image, size), &typeRef<double>, 0, "", ""}};

struct Plain {
    long long time = 0;
};
constexpr Member kPlain[] = {{"time", offsetof(Plain, time), &typeRef<long long>, 0, "@stamp when it was read", ""}};

struct Wrong {
    double time = 0;
};
constexpr Member kWrong[] = {{"time", offsetof(Wrong, time), &typeRef<double>, 0, "@stamp", ""}};

struct Unmarked {
    long long stamp = 0;
};
constexpr Member kUnmarked[] = {{"stamp", offsetof(Unmarked, stamp), &typeRef<long long>, 0, "", ""}};

template <class T, std::size_t N>
void add(const char* name, const Member (&members)[N]) {
    if (RTT::types::Types()->getTypeById(typeid(T).name())) return;
    RTT::types::Types()->addType(RTT::types::makeStructType<T>(name, members, N));
}

}  // namespace stamp_test

namespace {

using namespace stamp_test;

class Stamps : public EncodedTypes {
protected:
    static void SetUpTestSuite() {
        EncodedTypes::SetUpTestSuite();
        add<Time>("/stamp/Time", kTime);
        add<Header>("/stamp/Header", kHeader);
        add<Image>("/stamp/Image", kImage);
        add<Plain>("/stamp/Plain", kPlain);
        add<Wrong>("/stamp/Wrong", kWrong);
        add<Unmarked>("/stamp/Unmarked", kUnmarked);
    }
    template <class T>
    static std::unique_ptr<const Stamp> stampOf(std::string& why) {
        return Stamp::make(*RTT::types::Types()->getTypeById(typeid(T).name()), why);
    }
};

TEST_F(Stamps, AreFoundInStructsOfStructs) {
    std::string why;
    const auto stamp = stampOf<Image>(why);
    ASSERT_TRUE(stamp) << why;
    Image image;
    image.header.stamp = {12, 34};
    EXPECT_EQ(12000000034U, stamp->read(&image));
    image.header.stamp = {2000000000, 999999999};
    EXPECT_EQ(2000000000999999999U, stamp->read(&image));
    image.header.stamp = {-1, 0};
    EXPECT_EQ(0U, stamp->read(&image));
    image.header.stamp = {1, 4000000000U};
    EXPECT_EQ(0U, stamp->read(&image));
}

TEST_F(Stamps, AreNanosecondsIfTheyAreANumber) {
    std::string why;
    const auto stamp = stampOf<Plain>(why);
    ASSERT_TRUE(stamp) << why;
    const Plain later{77};
    EXPECT_EQ(77U, stamp->read(&later));
    const Plain before{std::numeric_limits<long long>::min()};
    EXPECT_EQ(0U, stamp->read(&before));
}

TEST_F(Stamps, AreOnlyTheMarkedFields) {
    std::string why = "old";
    EXPECT_FALSE(stampOf<Unmarked>(why));
    EXPECT_EQ("", why);
    EXPECT_FALSE(Stamp::make(*RTT::types::Types()->getTypeById(typeid(double).name()), why));
    EXPECT_EQ("", why);
    EXPECT_FALSE(stampOf<Wrong>(why));
    EXPECT_THAT(why, HasSubstr("its field 'time' is marked @stamp, but is neither an integer of 64 bits nor a struct"));
}

}  // namespace
