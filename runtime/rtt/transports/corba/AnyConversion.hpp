// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_ANY_CONVERSION_HPP
#define ORO_CORBA_ANY_CONVERSION_HPP

#include <rtt/transports/corba/OrocosTypesC.h>
#include <rtt/transports/corba/corba.h>

#include <memory>
#include <typeinfo>

/** An Any for the operators of omniidl. They are in the global namespace, as this is, so that templates find even those
    that are declared later. */
template <class AnyT>
struct RttCorbaAny {
    AnyT& any;
    operator AnyT&() const { return any; }
};

namespace RTT {
namespace corba {

template <class T>
struct AnyConversion;

/** Logs an error, once for each type, which says that AnyConversion has no specialisation for it. False. */
RTT_API bool lacksConversion(const std::type_info& type);

/**
 * Moves values of T through the IDL type CorbaT, for specialisations of AnyConversion to derive from. They define
 * toStdType() and toCorbaType(), unless both types are the same. Any thread may use it; nothing blocks. Truncated data
 * of another process throw CORBA::MARSHAL.
 */
template <class T, class CorbaT = T>
struct AnyConversionHelper {
    typedef T StdType;
    typedef CorbaT CorbaType;
    typedef CAnySequence sequence;

    /** The caller owns the result. */
    static CorbaType* toAny(const StdType& value) {
        std::unique_ptr<CorbaType> made(new CorbaType());
        return AnyConversion<T>::toCorbaType(*made, value) ? made.release() : nullptr;
    }
    /** A default value if the conversion fails. */
    static StdType get(const CorbaType* value) {
        StdType made = StdType();
        if (value) (void)AnyConversion<T>::toStdType(made, *value);
        return made;
    }
    /** False, with the value unchanged, if another type is in the Any. */
    static bool update(const CORBA::Any& any, StdType& value) {
        const CorbaType* found = nullptr;
        return (RttCorbaAny<const CORBA::Any>{any} >>= found) && AnyConversion<T>::toStdType(value, *found);
    }
    /** The caller owns the result; null if the conversion fails. */
    static CORBA::Any_ptr createAny(const StdType& value) {
        std::unique_ptr<CORBA::Any> made(new CORBA::Any());
        return AnyConversion<T>::updateAny(value, *made) ? made.release() : nullptr;
    }
    /** False, with the Any unchanged, if the conversion fails. */
    static bool updateAny(const StdType& value, CORBA::Any& any) {
        CorbaType* const made = AnyConversion<T>::toAny(value);
        if (made) RttCorbaAny<CORBA::Any>{any} <<= made;  // which owns it from now on
        return made != nullptr;
    }
    static bool toStdType(StdType& to, const CorbaType& from) {
        to = from;
        return true;
    }
    static bool toCorbaType(CorbaType& to, const StdType& from) {
        to = from;
        return true;
    }
};

/**
 * Puts values of T into a CORBA::Any and takes them out. Specialise it for a type of yours in namespace RTT::corba;
 * CorbaTemplateProtocol uses createAny(), updateAny() and update(). As part of a container, a type also needs
 * `sequence`, toStdType() and toCorbaType(); if `sequence` is CAnySequence, the former three are enough.
 *
 * This one is for types without a specialisation: everything fails, with one error logged for the type.
 */
template <class T>
struct AnyConversion {
    typedef T StdType;
    typedef CORBA::Any CorbaType;
    typedef CAnySequence sequence;

    static CorbaType* toAny(const StdType&) {
        (void)lacksConversion(typeid(T));
        return nullptr;
    }
    static StdType get(const CorbaType*) {
        (void)lacksConversion(typeid(T));
        return StdType();
    }
    static bool update(const CORBA::Any&, StdType&) { return lacksConversion(typeid(T)); }
    static CORBA::Any_ptr createAny(const StdType& value) { return toAny(value); }
    static bool updateAny(const StdType&, CORBA::Any&) { return lacksConversion(typeid(T)); }
    static bool toStdType(StdType&, const CorbaType&) { return lacksConversion(typeid(T)); }
    static bool toCorbaType(CorbaType&, const StdType&) { return lacksConversion(typeid(T)); }
};

}  // namespace corba
}  // namespace RTT

#endif
