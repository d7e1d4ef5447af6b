// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Headers that user code does not include itself: components rely on <rtt/TaskContext.hpp> for them.
#ifndef ORO_USUAL_INCLUDES_HPP
#define ORO_USUAL_INCLUDES_HPP

#ifndef BOOST_BIND_GLOBAL_PLACEHOLDERS
#define BOOST_BIND_GLOBAL_PLACEHOLDERS  // user code writes _1, not boost::placeholders::_1
#endif
#include <boost/bind.hpp>
#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>

#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Operation.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/Service.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/Time.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#endif
