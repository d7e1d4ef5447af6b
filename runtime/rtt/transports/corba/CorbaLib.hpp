// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_LIB_HPP
#define ORO_CORBA_LIB_HPP

/** The protocol of CORBA, for ConnPolicy::transport and TypeInfo::addProtocol(). */
#define ORO_CORBA_PROTOCOL_ID 1

#endif
