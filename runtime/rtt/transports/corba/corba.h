// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The headers of the ORB, for code that was written for one of several.
#ifndef ORO_CORBA_H
#define ORO_CORBA_H

#include <rtt/transports/corba/rtt-corba-config.h>

#include <omniORB4/CORBA.h>

namespace CORBA {
typedef Any* Any_ptr;
}

#define CORBA_CHECK_THREAD()
#define CORBA_EXCEPTION_INFO(e) (e._name())
#define ACE_THROW_SPEC(x)
#define ACE_THROW(x)

#endif
