// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_REFERENCE_HPP
#define ORO_CORBA_DETAIL_REMOTE_REFERENCE_HPP

#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/corba.h>

#include <omniORB4/omniORB.h>

#include <mutex>

namespace RTT {
namespace corba {
namespace detail {

/** The same object; calls by this reference throw CORBA::TIMEOUT after three seconds. The caller owns it. */
inline CORBA::Object_ptr limitedObject(CORBA::Object_ptr reference) {
    const CORBA::ORB_var orb = ApplicationServer::orb;
    if (CORBA::is_nil(reference) || CORBA::is_nil(orb)) return CORBA::Object::_nil();
    // A reference of its own, because the limit is one of the reference.
    const CORBA::String_var text = orb->object_to_string(reference);
    const CORBA::Object_ptr copy = orb->string_to_object(text);
    omniORB::setClientCallTimeout(copy, 3000);
    return copy;
}
template <class Interface>
typename Interface::_var_type limited(typename Interface::_ptr_type reference) {
    const CORBA::Object_var copy = limitedObject(reference);
    return Interface::_unchecked_narrow(copy);
}

/** A service of another process, which becomes another object when that process starts again. Any thread may use it. */
class RemoteReference {
public:
    /** For calls that may last as long as they want. */
    CService_var get() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return current_;
    }
    CService_var getLimited() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return limited_;
    }
    void set(CService_ptr service) {
        const CService_var copy = limited<CService>(service);
        const std::lock_guard<std::mutex> lock(mutex_);
        current_ = CService::_duplicate(service);
        limited_ = copy;
    }

private:
    mutable std::mutex mutex_;
    CService_var current_, limited_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
