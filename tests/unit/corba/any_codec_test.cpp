// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values in a CORBA::Any, against the code that omniidl generates from the IDL that the original toolchain would write.
#include "any_wire.hpp"

#include <rtt/transports/corba/detail/any_codec.hpp>

#include "../types/builtin_typekit.hpp"
#include "../types/sample_types.hpp"
#include "sampleC.h"

#include <cstring>
#include <string>

using corba_test::orb;
using corba_test::sent;
using RTT::corba::detail::AnyCodec;
namespace idl = orogen::sample::Corba;

namespace {

class AnyCodecs : public types_test::WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        types_test::WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
    }
    template <class T>
    static std::shared_ptr<const AnyCodec> codecOf() {
        std::string why;
        auto codec = AnyCodec::make(*RTT::types::Types()->getTypeInfo<T>(), orb(), why);
        EXPECT_TRUE(codec) << why;
        return codec;
    }
    template <class T>
    static void isSentAs(const T& value, CORBA::TCKind kind) {
        const auto codec = codecOf<T>();
        EXPECT_EQ(codec->typeCode()->kind(), kind);
        CORBA::Any any;
        ASSERT_TRUE(codec->put(&value, any));
        for (const bool little : {true, false}) {
            T back{};
            std::string why;
            EXPECT_TRUE(codec->get(*sent(any, little), &back, why)) << why;
            EXPECT_EQ(back, value);
        }
    }
    static std::string dataOf(const CORBA::Any& any) {
        cdrMemoryStream bytes(_CORBA_ULong(0), true);  // its padding is zero
        any.NP_marshalDataOnly(bytes);
        return std::string(static_cast<const char*>(bytes.bufPtr()), bytes.bufSize());
    }
    static sample::Tank tank() {
        sample::Tank made;
        made.id = 3;
        made.label = "main";
        made.position = {1, 2};
        made.levels = {0.5, 0.25};
        made.path = {{1, 2}, {3, 4}, {5, 6}};
        made.weights[1] = 7;
        made.pair = {{4, 5}};
        made.mode = sample::Mode::Filling;
        made.small = 200;
        made.flags = {true, false, true};
        return made;
    }
};

}  // namespace

TEST_F(AnyCodecs, HaveTheTypesOfTheOriginal) {
    isSentAs(true, CORBA::tk_boolean);
    isSentAs('x', CORBA::tk_char);
    isSentAs(-3, CORBA::tk_long);
    isSentAs(3U, CORBA::tk_ulong);
    isSentAs(-3LL, CORBA::tk_longlong);
    isSentAs(3ULL, CORBA::tk_ulonglong);
    isSentAs(0.5F, CORBA::tk_float);
    isSentAs(0.5, CORBA::tk_double);
    isSentAs(std::string("text"), CORBA::tk_string);
    isSentAs(std::vector<double>{1, 2, 3}, CORBA::tk_alias);
    isSentAs(sample::Mode::Draining, CORBA::tk_enum);
    EXPECT_STREQ(codecOf<std::vector<double>>()->typeCode()->id(), "IDL:omg.org/CORBA/DoubleSeq:1.0");
    EXPECT_STREQ(codecOf<std::vector<double>>()->typeCode()->name(), "DoubleSeq");
}

TEST_F(AnyCodecs, HaveTheTypeCodesThatOmniidlMakes) {
    EXPECT_TRUE(codecOf<sample::Tank>()->typeCode()->equal(idl::_tc_Tank));
    EXPECT_TRUE(codecOf<sample::Point>()->typeCode()->equal(idl::_tc_Point));
    EXPECT_TRUE(codecOf<sample::Mode>()->typeCode()->equal(idl::_tc_Mode));
    EXPECT_TRUE(codecOf<std::vector<sample::Point>>()->typeCode()->equal(idl::_tc_vector__sample_Point_));
}

TEST_F(AnyCodecs, WriteTheBytesThatGeneratedCodeReads) {
    const sample::Tank value = tank();
    CORBA::Any ours;
    ASSERT_TRUE(codecOf<sample::Tank>()->put(&value, ours));
    for (const bool little : {true, false}) {
        const auto received = sent(ours, little);
        const idl::Tank* theirs = nullptr;
        ASSERT_TRUE(*received >>= theirs);
        EXPECT_EQ(theirs->id, 3);
        EXPECT_STREQ(theirs->label, "main");
        EXPECT_EQ(theirs->position.y, 2);
        ASSERT_EQ(theirs->levels.length(), 2U);
        EXPECT_EQ(theirs->levels[1], 0.25);
        ASSERT_EQ(theirs->path.length(), 3U);
        EXPECT_EQ(theirs->path[2].x, 5);
        EXPECT_EQ(theirs->weights[1], 7);
        EXPECT_EQ(theirs->pair[1], 5);
        EXPECT_EQ(theirs->mode, idl::Filling);
        EXPECT_EQ(theirs->small, 200);
        ASSERT_EQ(theirs->flags.length(), 3U);
        EXPECT_TRUE(theirs->flags[2]);
        CORBA::Any again;
        again <<= *theirs;
        EXPECT_EQ(dataOf(again), dataOf(ours));
    }
}

TEST_F(AnyCodecs, ReadTheBytesThatGeneratedCodeWrites) {
    idl::Tank theirs;
    theirs.id = 9;
    theirs.label = "side";
    theirs.position.x = 4;
    theirs.position.y = 0;
    theirs.levels.length(1);
    theirs.levels[0] = 8;
    theirs.path.length(1);
    theirs.path[0].x = 1;
    theirs.path[0].y = 6;
    for (double& weight : theirs.weights) weight = 2;
    theirs.pair[0] = theirs.pair[1] = 1;
    theirs.mode = idl::Idle;
    theirs.small = 1;
    theirs.flags.length(1);
    theirs.flags[0] = true;
    CORBA::Any any;
    any <<= theirs;
    const auto codec = codecOf<sample::Tank>();
    sample::Tank back;
    std::string why;
    ASSERT_TRUE(codec->get(any, &back, why)) << "in the same process: " << why;
    EXPECT_EQ(back.label, "side");
    for (const bool little : {true, false}) {
        back = sample::Tank();
        ASSERT_TRUE(codec->get(*sent(any, little), &back, why)) << why;
        EXPECT_EQ(back.id, 9);
        EXPECT_EQ(back.path.at(0).y, 6);
        EXPECT_EQ(back.mode, sample::Mode::Idle);
        EXPECT_EQ(back.flags, std::vector<bool>{true});
    }
}

TEST_F(AnyCodecs, RefuseOtherTypes) {
    CORBA::Any any;
    std::string why;
    int number = 5;
    EXPECT_FALSE(codecOf<int>()->get(any, &number, why)) << "nothing is in it";
    any <<= 2.5;
    EXPECT_FALSE(codecOf<int>()->get(any, &number, why));
    EXPECT_EQ(why, "it has another type");
    EXPECT_EQ(number, 5);
    sample::Point point;
    CORBA::Any other;
    other <<= idl::Idle;
    EXPECT_FALSE(codecOf<sample::Point>()->get(other, &point, why));
}

TEST_F(AnyCodecs, AcceptASequenceWithoutItsAlias) {
    CORBA::DoubleSeq numbers;
    numbers.length(2);
    numbers[0] = 1;
    numbers[1] = 2;
    CORBA::Any any;
    any <<= numbers;
    std::vector<double> back;
    std::string why;
    EXPECT_TRUE(codecOf<std::vector<double>>()->get(any, &back, why)) << why;
    EXPECT_EQ(back, (std::vector<double>{1, 2}));
}
