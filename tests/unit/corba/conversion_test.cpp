// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The conversions that users build on.
#include "any_wire.hpp"

#include <rtt/transports/corba/CorbaConnPolicy.hpp>
#include <rtt/transports/corba/RTTCorbaConversion.hpp>

#include <gtest/gtest.h>

#include <string>

using namespace RTT;
using corba::AnyConversion;
using corba_test::orb;
using corba_test::sent;

namespace {

struct Unknown {};

class AnyConversions : public testing::Test {
protected:
    static void SetUpTestSuite() { (void)orb(); }

    /** The value as another process gets it. */
    template <class T>
    static void isSentAs(const T& value, CORBA::TCKind kind) {
        const CORBA::Any_var any = AnyConversion<T>::createAny(value);
        EXPECT_EQ(any->NP_type()->kind(), kind);
        CORBA::Any again;
        EXPECT_TRUE(AnyConversion<T>::updateAny(value, again));
        EXPECT_TRUE(again.NP_type()->equal(any->NP_type()));
        for (const bool little : {true, false}) {
            T back = T();
            EXPECT_TRUE(AnyConversion<T>::update(*sent(again, little), back));
            EXPECT_EQ(back, value);
        }
    }
    template <class T>
    static const char* idOf(const T& value) {
        static CORBA::Any_var any;
        any = AnyConversion<T>::createAny(value);
        return any->NP_type()->id();
    }
    /** Only `Sent` can be taken out of an Any with a value of it. */
    template <class Sent, class T>
    static void isRefused() {
        const CORBA::Any_var any = AnyConversion<Sent>::createAny(Sent());
        T value = T(5);
        EXPECT_FALSE(AnyConversion<T>::update(any.in(), value));
        EXPECT_EQ(value, T(5));
    }
};

}  // namespace

TEST_F(AnyConversions, HaveTheTypesOfTheOriginal) {
    isSentAs(0.5, CORBA::tk_double);
    isSentAs(0.5F, CORBA::tk_float);
    isSentAs(-3, CORBA::tk_long);
    isSentAs(3U, CORBA::tk_ulong);
    isSentAs(-3LL, CORBA::tk_longlong);
    isSentAs(3ULL, CORBA::tk_ulonglong);
    isSentAs(true, CORBA::tk_boolean);
    isSentAs('x', CORBA::tk_char);
    isSentAs(std::string("text"), CORBA::tk_string);
    isSentAs(rt_string("text"), CORBA::tk_string);
}

TEST_F(AnyConversions, OfContainersUseTheStandardSequences) {
    isSentAs(std::vector<double>{1, 2}, CORBA::tk_alias);
    isSentAs(std::vector<bool>{true, false, true}, CORBA::tk_alias);
    isSentAs(std::vector<char>{'a'}, CORBA::tk_alias);
    isSentAs(std::vector<std::string>{"a", "", "b c"}, CORBA::tk_alias);
    isSentAs(std::vector<int>(), CORBA::tk_alias);
    EXPECT_STREQ(idOf(std::vector<double>{1}), "IDL:omg.org/CORBA/DoubleSeq:1.0");
    EXPECT_STREQ(idOf(std::vector<bool>{true}), "IDL:omg.org/CORBA/BooleanSeq:1.0");
    EXPECT_STREQ(idOf(std::vector<long long>{1}), "IDL:omg.org/CORBA/LongLongSeq:1.0");
    EXPECT_STREQ(idOf(std::vector<std::string>{"a"}), "IDL:omg.org/CORBA/StringSeq:1.0");
}

TEST_F(AnyConversions, OfContainersOfContainersUseAnys) {
    isSentAs(std::vector<std::vector<double>>{{1, 2}, {}, {3}}, CORBA::tk_alias);
    isSentAs(std::pair<std::string, int>("a", 3), CORBA::tk_struct);
    isSentAs(std::map<std::string, double>{{"a", 1}, {"b", 2}}, CORBA::tk_alias);
    isSentAs(std::vector<std::map<int, std::string>>{{{1, "a"}}, {}}, CORBA::tk_alias);
    isSentAs(std::vector<std::pair<int, int>>{{1, 2}}, CORBA::tk_alias);
    EXPECT_STREQ(idOf(std::vector<std::vector<double>>()), "IDL:RTT/corba/CAnySequence:1.0");
    EXPECT_STREQ(idOf(std::pair<int, int>()), "IDL:RTT/corba/Pair:1.0");
    EXPECT_STREQ(idOf(std::map<int, int>()), "IDL:RTT/corba/PairSeq:1.0");
}

TEST_F(AnyConversions, RefuseOtherTypes) {
    isRefused<int, double>();
    isRefused<float, double>();
    isRefused<double, float>();
    isRefused<unsigned, int>();
    isRefused<int, long long>();
    isRefused<bool, char>();
    isRefused<int, bool>();
    isRefused<std::string, int>();
    isRefused<std::vector<double>, double>();
    std::string text = "kept";
    EXPECT_FALSE(AnyConversion<std::string>::update(CORBA::Any(), text));
    EXPECT_EQ(text, "kept");
    std::vector<double> numbers{1};
    const CORBA::Any_var others = AnyConversion<std::vector<int>>::createAny({2, 3});
    EXPECT_FALSE(AnyConversion<std::vector<double>>::update(others.in(), numbers));
    EXPECT_EQ(numbers, std::vector<double>{1});
    std::map<std::string, int> map{{"kept", 1}};
    const CORBA::Any_var wrong = AnyConversion<std::map<std::string, double>>::createAny({{"a", 1}});
    EXPECT_FALSE((AnyConversion<std::map<std::string, int>>::update(wrong.in(), map)));
    EXPECT_EQ(map.count("kept"), 1U);
}

TEST_F(AnyConversions, OfTextEndAtTheFirstZero) {
    const CORBA::Any_var any = AnyConversion<std::string>::createAny(std::string("ab\0cd", 5));
    std::string back;
    EXPECT_TRUE(AnyConversion<std::string>::update(any.in(), back));
    EXPECT_EQ(back, "ab");
}

TEST_F(AnyConversions, FailForTypesWithoutOne) {
    Unknown unknown;
    CORBA::Any any;
    EXPECT_FALSE(AnyConversion<Unknown>::update(any, unknown));
    EXPECT_FALSE(AnyConversion<Unknown>::updateAny(unknown, any));
    EXPECT_EQ(AnyConversion<Unknown>::createAny(unknown), nullptr);
    std::vector<Unknown> none;
    EXPECT_FALSE(AnyConversion<std::vector<Unknown>>::update(any, none));
}

TEST_F(AnyConversions, OfAPolicyKeepAllMembers) {
    ConnPolicy policy = ConnPolicy::buffer(7, ConnPolicy::LOCKED, true, true);
    policy.buffer_policy = PerOutputPort;
    policy.max_threads = 3;
    policy.mandatory = false;
    policy.transport = 2;
    policy.data_size = 40;
    policy.name_id = "stream";
    const CORBA::Any_var any = AnyConversion<ConnPolicy>::createAny(policy);
    EXPECT_EQ(any->NP_type()->kind(), CORBA::tk_struct);
    EXPECT_STREQ(any->NP_type()->id(), "IDL:RTT/corba/CConnPolicy:1.0");
    ConnPolicy back;
    ASSERT_TRUE(AnyConversion<ConnPolicy>::update(*sent(any.in(), false), back));
    EXPECT_EQ(back.type, ConnPolicy::BUFFER);
    EXPECT_EQ(back.size, 7);
    EXPECT_EQ(back.lock_policy, ConnPolicy::LOCKED);
    EXPECT_TRUE(back.init);
    EXPECT_TRUE(back.pull);
    EXPECT_EQ(back.buffer_policy, PerOutputPort);
    EXPECT_EQ(back.max_threads, 3);
    EXPECT_FALSE(back.mandatory);
    EXPECT_EQ(back.transport, 2);
    EXPECT_EQ(back.data_size, 40);
    EXPECT_EQ(back.name_id, "stream");
}

TEST_F(AnyConversions, OfAnAnyPutItIntoAnother) {
    const CORBA::Any_var inner = AnyConversion<int>::createAny(4);
    const CORBA::Any_var outer = AnyConversion<CORBA::Any_var>::createAny(inner);
    EXPECT_EQ(outer->NP_type()->kind(), CORBA::tk_any);
    CORBA::Any_ptr back = nullptr;
    ASSERT_TRUE(AnyConversion<CORBA::Any_ptr>::update(*sent(outer.in(), true), back));
    const CORBA::Any_var owned(back);
    int number = 0;
    EXPECT_TRUE(AnyConversion<int>::update(owned.in(), number));
    EXPECT_EQ(number, 4);
    EXPECT_EQ(AnyConversion<CORBA::Any_ptr>::createAny(nullptr), nullptr);
}
