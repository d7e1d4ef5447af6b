// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How values get into a CORBA::Any, for transports that are written by hand: AnyConversion, of numbers, texts and
// containers.
#ifndef ORO_CORBA_CONVERSION_HPP
#define ORO_CORBA_CONVERSION_HPP

#include <rtt/transports/corba/AnyConversion.hpp>
#include <rtt/transports/corba/BasicConversions.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace RTT {
namespace corba {

/** The elements of containers: those of a sequence of Anys are Anys, others are IDL types. */
struct ElementConversion {
    template <class T>
    static bool toCorba(CORBA::Any& to, const T& from) {
        return AnyConversion<T>::updateAny(from, to);
    }
    template <class T, class Element>
    static bool toCorba(Element&& to, const T& from) {
        return AnyConversion<T>::toCorbaType(to, from);
    }
    template <class T>
    static bool toStd(T& to, const CORBA::Any& from) {
        return AnyConversion<T>::update(from, to);
    }
    template <class T, class Element>
    static bool toStd(T& to, const Element& from) {
        return AnyConversion<T>::toStdType(to, from);
    }
};

/** As the sequence of AnyConversion<T>. */
template <class T>
struct AnyConversion<std::vector<T>> : public AnyConversionHelper<std::vector<T>, typename AnyConversion<T>::sequence> {
    typedef std::vector<T> StdType;
    typedef typename AnyConversion<T>::sequence CorbaType;

    /** If that fails, `to` is unchanged. */
    static bool toStdType(StdType& to, const CorbaType& from) {
        StdType made(from.length());
        for (CORBA::ULong i = 0; i != from.length(); ++i) {
            T element = T();
            if (!ElementConversion::toStd<T>(element, from[i])) return false;
            made[i] = std::move(element);
        }
        to.swap(made);
        return true;
    }
    static bool toCorbaType(CorbaType& to, const StdType& from) {
        to.length(static_cast<CORBA::ULong>(from.size()));
        for (std::size_t i = 0; i != from.size(); ++i)
            if (!ElementConversion::toCorba<T>(to[static_cast<CORBA::ULong>(i)], from[i])) return false;
        return true;
    }
};

/** As a Pair of Anys. */
template <class First, class Second>
struct AnyConversion<std::pair<First, Second>> : public AnyConversionHelper<std::pair<First, Second>, Pair> {
    typedef std::pair<First, Second> StdType;
    typedef Pair CorbaType;
    typedef PairSeq sequence;

    /** If that fails, `to` is unchanged. */
    static bool toStdType(StdType& to, const CorbaType& from) {
        StdType made = StdType();
        if (!AnyConversion<First>::update(from.t1, made.first)) return false;
        if (!AnyConversion<Second>::update(from.t2, made.second)) return false;
        to = std::move(made);
        return true;
    }
    static bool toCorbaType(CorbaType& to, const StdType& from) {
        return AnyConversion<First>::updateAny(from.first, to.t1) &&
               AnyConversion<Second>::updateAny(from.second, to.t2);
    }
};

/** As a sequence of Pairs. */
template <class Key, class Value>
struct AnyConversion<std::map<Key, Value>> : public AnyConversionHelper<std::map<Key, Value>, PairSeq> {
    typedef std::map<Key, Value> StdType;
    typedef PairSeq CorbaType;

    /** If that fails, `to` is unchanged. */
    static bool toStdType(StdType& to, const CorbaType& from) {
        StdType made;
        for (CORBA::ULong i = 0; i != from.length(); ++i) {
            std::pair<Key, Value> entry;
            if (!AnyConversion<std::pair<Key, Value>>::toStdType(entry, from[i])) return false;
            made[entry.first] = entry.second;
        }
        to.swap(made);
        return true;
    }
    static bool toCorbaType(CorbaType& to, const StdType& from) {
        to.length(static_cast<CORBA::ULong>(from.size()));
        CORBA::ULong i = 0;
        for (const auto& entry : from)
            if (!AnyConversion<std::pair<Key, Value>>::toCorbaType(to[i++], entry)) return false;
        return true;
    }
};

}  // namespace corba
}  // namespace RTT

#endif
