// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Numbers and texts. Only values of exactly the same type are taken out of an Any: no long becomes a double.
#ifndef ORO_CORBA_BASIC_CONVERSIONS_HPP
#define ORO_CORBA_BASIC_CONVERSIONS_HPP

#include <rtt/rt_string.hpp>
#include <rtt/transports/corba/AnyConversion.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace corba {

/** Of numbers. */
template <class T, class CorbaT, class Sequence>
struct NumberConversion {
    typedef T StdType;
    typedef CorbaT CorbaType;
    typedef Sequence sequence;

    static CorbaType toAny(StdType value) { return static_cast<CorbaType>(value); }
    static StdType get(CorbaType value) { return static_cast<StdType>(value); }
    static bool update(const CORBA::Any& any, StdType& value) {
        CorbaType found = CorbaType();
        if (!extract(any, found)) return false;
        value = get(found);
        return true;
    }
    static CORBA::Any_ptr createAny(StdType value) {
        std::unique_ptr<CORBA::Any> made(new CORBA::Any());
        insert(*made, toAny(value));
        return made.release();
    }
    static bool updateAny(StdType value, CORBA::Any& any) {
        insert(any, toAny(value));
        return true;
    }
    static bool toStdType(StdType& to, CorbaType from) {
        to = get(from);
        return true;
    }
    static bool toCorbaType(CorbaType& to, StdType from) {
        to = toAny(from);
        return true;
    }

private:
    template <class Number>
    static bool extract(const CORBA::Any& any, Number& value) {
        return any >>= value;
    }
    static bool extract(const CORBA::Any& any, CORBA::Boolean& value) { return any >>= CORBA::Any::to_boolean(value); }
    static bool extract(const CORBA::Any& any, CORBA::Char& value) { return any >>= CORBA::Any::to_char(value); }
    template <class Number>
    static void insert(CORBA::Any& any, Number value) {
        any <<= value;
    }
    static void insert(CORBA::Any& any, CORBA::Boolean value) { any <<= CORBA::Any::from_boolean(value); }
    static void insert(CORBA::Any& any, CORBA::Char value) { any <<= CORBA::Any::from_char(value); }
};

template <>
struct AnyConversion<double> : public NumberConversion<double, CORBA::Double, CORBA::DoubleSeq> {};
template <>
struct AnyConversion<float> : public NumberConversion<float, CORBA::Float, CORBA::FloatSeq> {};
template <>
struct AnyConversion<int> : public NumberConversion<int, CORBA::Long, CORBA::LongSeq> {};
template <>
struct AnyConversion<unsigned int> : public NumberConversion<unsigned int, CORBA::ULong, CORBA::ULongSeq> {};
template <>
struct AnyConversion<long long> : public NumberConversion<long long, CORBA::LongLong, CORBA::LongLongSeq> {};
template <>
struct AnyConversion<unsigned long long>
    : public NumberConversion<unsigned long long, CORBA::ULongLong, CORBA::ULongLongSeq> {};
template <>
struct AnyConversion<bool> : public NumberConversion<bool, CORBA::Boolean, CORBA::BooleanSeq> {};
template <>
struct AnyConversion<char> : public NumberConversion<char, CORBA::Char, CORBA::CharSeq> {};

/** Of texts, which end at the first zero letter. */
template <class Text>
struct TextConversion {
    typedef Text StdType;
    typedef const char* CorbaType;
    typedef CORBA::StringSeq sequence;

    /** Borrowed from the text. */
    static CorbaType toAny(const StdType& text) { return text.c_str(); }
    static StdType get(CorbaType text) { return text ? StdType(text) : StdType(); }
    static bool update(const CORBA::Any& any, StdType& text) {
        CorbaType found = nullptr;
        return (any >>= found) && toStdType(text, found);
    }
    static CORBA::Any_ptr createAny(const StdType& text) {
        std::unique_ptr<CORBA::Any> made(new CORBA::Any());
        (void)updateAny(text, *made);
        return made.release();
    }
    static bool updateAny(const StdType& text, CORBA::Any& any) {
        any <<= toAny(text);
        return true;
    }
    static bool toStdType(StdType& to, CorbaType from) {
        to = from ? from : "";
        return true;
    }
    /** Borrows from the text. */
    static bool toCorbaType(CorbaType& to, const StdType& from) {
        to = toAny(from);
        return true;
    }
    /** An element of a sequence, or a member of a struct, which copies the text. */
    template <class Element>
    static bool toCorbaType(Element& to, const StdType& from) {
        to = toAny(from);
        return true;
    }
};

template <>
struct AnyConversion<std::string> : public TextConversion<std::string> {};
template <>
struct AnyConversion<rt_string> : public TextConversion<rt_string> {};

}  // namespace corba
}  // namespace RTT

#endif
