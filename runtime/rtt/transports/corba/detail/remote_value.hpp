// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_REMOTE_VALUE_HPP
#define ORO_CORBA_DETAIL_REMOTE_VALUE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/transports/corba/ConfigurationInterfaceC.h>
#include <rtt/transports/corba/detail/remote_peer.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {
namespace detail {

/** Reads and writes a property or an attribute of another process. */
struct RemoteAccess {
    enum class Kind { Property, Attribute };

    std::shared_ptr<RemotePeer> peer;
    std::shared_ptr<const RemoteReference> service;
    Kind kind;
    std::string name;

    /** False if that fails. */
    bool fetch(const base::DataSourceBase::shared_ptr& into) const;
    bool store(const base::DataSourceBase::shared_ptr& from) const;
};

/** A source whose value is in another process: every reading fetches it, every change stores it. Null if values of the
    type do not cross CORBA. */
base::DataSourceBase::shared_ptr newRemoteValue(const types::TypeInfo& type, RemoteAccess access, bool isAssignable);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
