// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The conversions of all types that the runtime itself has.
#ifndef ORO_RTT_CORBA_CONVERSION_HPP
#define ORO_RTT_CORBA_CONVERSION_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/transports/corba/CorbaConversion.hpp>
#include <rtt/transports/corba/DataFlowC.h>
#include <rtt/transports/corba/TaskContextC.h>

namespace RTT {
class TaskContext;
namespace corba {

template <>
struct RTT_API AnyConversion<ConnPolicy> : public AnyConversionHelper<ConnPolicy, CConnPolicy> {
    static bool toStdType(ConnPolicy& to, const CConnPolicy& from);
    static bool toCorbaType(CConnPolicy& to, const ConnPolicy& from);
};

/** A component, by its reference. These functions call other processes and block. */
template <>
struct RTT_API AnyConversion<TaskContext*> {
    typedef TaskContext* StdType;
    typedef CTaskContext_ptr CorbaType;
    typedef CAnySequence sequence;

    /** The reference of a component, which other processes can call from now on, or that which a proxy has. The caller
        owns it. Nil for null, or with an error logged. */
    static CorbaType toAny(TaskContext* component);
    /** The component if it is in this process, otherwise its proxy. Null for nil, or with an error logged. */
    static TaskContext* get(CorbaType reference);
    /** Leaves the value if there is no component in the Any. Always true, as others expect. */
    static bool update(const CORBA::Any& any, TaskContext*& component);
    /** An empty Any for null. */
    static CORBA::Any_ptr createAny(TaskContext* component);
    static bool updateAny(TaskContext* component, CORBA::Any& any);
    static bool toStdType(TaskContext*& to, CorbaType from);
    static bool toCorbaType(CorbaType& to, TaskContext* from);
};

/** An Any in an Any. */
template <>
struct RTT_API AnyConversion<CORBA::Any_ptr> {
    typedef CORBA::Any_ptr StdType;
    typedef CORBA::Any CorbaType;
    typedef CAnySequence sequence;

    /** Borrowed. */
    static CorbaType* toAny(StdType value) { return value; }
    static StdType get(CorbaType* value) { return value; }
    /** The caller owns the new value; the old one stays as it is. */
    static bool update(const CORBA::Any& any, StdType& value);
    static CORBA::Any_ptr createAny(StdType value);
    /** False for null. */
    static bool updateAny(StdType value, CORBA::Any& any);
    static bool toStdType(StdType& to, const CorbaType& from);
    static bool toCorbaType(CorbaType& to, StdType from);
};

template <>
struct RTT_API AnyConversion<CORBA::Any_var> {
    typedef CORBA::Any_var StdType;
    typedef CORBA::Any CorbaType;
    typedef CAnySequence sequence;

    /** Borrowed. */
    static CorbaType* toAny(const StdType& value);
    /** A copy. */
    static StdType get(const CorbaType* value);
    static bool update(const CORBA::Any& any, StdType& value);
    static CORBA::Any_ptr createAny(const StdType& value);
    /** False for an Any_var without an Any. */
    static bool updateAny(const StdType& value, CORBA::Any& any);
    static bool toStdType(StdType& to, const CorbaType& from);
    static bool toCorbaType(CorbaType& to, const StdType& from);
};

}  // namespace corba
}  // namespace RTT

#endif
