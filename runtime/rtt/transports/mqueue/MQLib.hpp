// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQ_LIB_HPP
#define ORO_MQ_LIB_HPP

/** The protocol of POSIX message queues, for ConnPolicy::transport and TypeInfo::addProtocol(). */
#define ORO_MQUEUE_PROTOCOL_ID 2

#endif
