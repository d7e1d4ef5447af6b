// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_RTT_CORBA_CONFIG_H
#define ORO_RTT_CORBA_CONFIG_H

#include <rtt/rtt-config.h>

#define RTT_CORBA_IMPLEMENTATION OMNIORB
#define CORBA_IS_OMNIORB 1

#define RTT_CORBA_API RTT_API
#define RTT_CORBA_EXPORT RTT_EXPORT
#define RTT_CORBA_HIDE RTT_HIDE

#endif
