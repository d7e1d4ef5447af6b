// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/RTTCorbaConversion.hpp>

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/CorbaConnPolicy.hpp>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>

#include <boost/core/demangle.hpp>

#include <mutex>
#include <set>
#include <string>

namespace RTT::corba {

bool lacksConversion(const std::type_info& type) {
    static std::mutex mutex;
    static auto* const reported = new std::set<std::string>();
    const std::lock_guard<std::mutex> lock(mutex);
    if (reported->insert(type.name()).second)
        log(Error) << "values of type " << boost::core::demangle(type.name())
                   << " do not cross CORBA: AnyConversion has no specialisation for it" << endlog();
    return false;
}

bool AnyConversion<ConnPolicy>::toStdType(ConnPolicy& to, const CConnPolicy& from) {
    to = toRTT(from);
    return true;
}
bool AnyConversion<ConnPolicy>::toCorbaType(CConnPolicy& to, const ConnPolicy& from) {
    to = toCORBA(from);
    return true;
}

CTaskContext_ptr AnyConversion<TaskContext*>::toAny(TaskContext* component) {
    return component ? TaskContextServer::CreateServer(component, false, false) : CTaskContext::_nil();
}
TaskContext* AnyConversion<TaskContext*>::get(CTaskContext_ptr reference) {
    return TaskContextProxy::Create(reference);
}
bool AnyConversion<TaskContext*>::update(const CORBA::Any& any, TaskContext*& component) {
    CTaskContext_ptr found = CTaskContext::_nil();  // borrowed
    if (any >>= found) (void)toStdType(component, found);
    return true;
}
CORBA::Any_ptr AnyConversion<TaskContext*>::createAny(TaskContext* component) {
    auto made = std::make_unique<CORBA::Any>();
    return updateAny(component, *made) ? made.release() : nullptr;
}
bool AnyConversion<TaskContext*>::updateAny(TaskContext* component, CORBA::Any& any) {
    if (!component) return true;
    const CTaskContext_var reference = toAny(component);
    if (CORBA::is_nil(reference)) return false;
    any <<= reference.in();
    return true;
}
bool AnyConversion<TaskContext*>::toStdType(TaskContext*& to, CTaskContext_ptr from) {
    TaskContext* const found = get(from);
    if (found) to = found;
    return found != nullptr;
}
bool AnyConversion<TaskContext*>::toCorbaType(CTaskContext_ptr& to, TaskContext* from) {
    to = toAny(from);
    return !from || !CORBA::is_nil(to);
}

bool AnyConversion<CORBA::Any_ptr>::update(const CORBA::Any& any, CORBA::Any_ptr& value) {
    const CORBA::Any* found = nullptr;
    return (any >>= found) && toStdType(value, *found);
}
CORBA::Any_ptr AnyConversion<CORBA::Any_ptr>::createAny(CORBA::Any_ptr value) {
    auto made = std::make_unique<CORBA::Any>();
    return updateAny(value, *made) ? made.release() : nullptr;
}
bool AnyConversion<CORBA::Any_ptr>::updateAny(CORBA::Any_ptr value, CORBA::Any& any) {
    if (value) any <<= *value;
    return value != nullptr;
}
bool AnyConversion<CORBA::Any_ptr>::toStdType(CORBA::Any_ptr& to, const CORBA::Any& from) {
    to = new CORBA::Any(from);
    return true;
}
bool AnyConversion<CORBA::Any_ptr>::toCorbaType(CORBA::Any& to, CORBA::Any_ptr from) {
    if (from) to = *from;
    return from != nullptr;
}

CORBA::Any* AnyConversion<CORBA::Any_var>::toAny(const CORBA::Any_var& value) {
    return const_cast<CORBA::Any*>(value.operator->());
}
CORBA::Any_var AnyConversion<CORBA::Any_var>::get(const CORBA::Any* value) {
    return value ? new CORBA::Any(*value) : nullptr;
}
bool AnyConversion<CORBA::Any_var>::update(const CORBA::Any& any, CORBA::Any_var& value) {
    const CORBA::Any* found = nullptr;
    return (any >>= found) && toStdType(value, *found);
}
CORBA::Any_ptr AnyConversion<CORBA::Any_var>::createAny(const CORBA::Any_var& value) {
    return AnyConversion<CORBA::Any_ptr>::createAny(toAny(value));
}
bool AnyConversion<CORBA::Any_var>::updateAny(const CORBA::Any_var& value, CORBA::Any& any) {
    return AnyConversion<CORBA::Any_ptr>::updateAny(toAny(value), any);
}
bool AnyConversion<CORBA::Any_var>::toStdType(CORBA::Any_var& to, const CORBA::Any& from) {
    to = new CORBA::Any(from);
    return true;
}
bool AnyConversion<CORBA::Any_var>::toCorbaType(CORBA::Any& to, const CORBA::Any_var& from) {
    return AnyConversion<CORBA::Any_ptr>::toCorbaType(to, toAny(from));
}

}  // namespace RTT::corba
