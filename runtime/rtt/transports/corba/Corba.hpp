// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * @file
 * The transport between computers. Other processes use components of this one by their references, and this one uses
 * theirs by proxies:
 *
 *   - RTT::corba::TaskContextServer lets other processes use a component of this one.
 *   - RTT::corba::TaskContextProxy is a component of another process.
 *   - RTT::corba::TaskContextFactory makes proxies for code that does not know the ORB.
 *   - RTT::corba::CorbaTypeTransporter converts values of one type; RTT::corba::CorbaTemplateProtocol makes one from an
 *     RTT::corba::AnyConversion.
 *
 * Types that are made of other types need none of the latter: the library knows them by their members.
 */
#ifndef ORO_CORBA_HPP
#define ORO_CORBA_HPP

#include <rtt/rtt-config.h>

#endif
