// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_END_POINT_HPP
#define ORO_CORBA_DETAIL_END_POINT_HPP

#include <string>

namespace RTT {
namespace corba {
namespace detail {

/** The host of "NameService=corbaloc:iiop:host:2809/NameService" or "NameService=corbaname::host"; empty if there is
    none. */
std::string hostOfReference(const std::string& reference);
/** The address of this computer by which that host is reached; empty if it is unknown. Blocks for a look-up of the
    name. */
std::string addressTowards(const std::string& host);
/** The address belongs to this computer only. */
bool isLoopback(const std::string& address);
/** An end point such as "giop:tcp:127.0.0.1:" or "giop:unix:…" can only be reached from this computer. */
bool isLocalEndPoint(const std::string& endPoint);

/** Other computers can connect to this process. True before setOthersCanConnect(). Any thread may call both. */
bool othersCanConnect();
void setOthersCanConnect(bool can);

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
