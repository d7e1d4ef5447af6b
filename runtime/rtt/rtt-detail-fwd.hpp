// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The namespaces of the runtime. Users write `using namespace RTT::detail`, or `Orocos`, after any header, so
// <rtt/rtt-config.h> includes this one.
#ifndef ORO_RTT_DETAIL_FWD_HPP
#define ORO_RTT_DETAIL_FWD_HPP

namespace RTT {
namespace base {}
namespace extras {}
namespace internal {}
namespace marsh {}
namespace os {}
namespace plugin {}
namespace scripting {}
namespace types {}
/** All namespaces at once. */
namespace detail {
using namespace base;
using namespace internal;
using namespace types;
using namespace os;
using namespace extras;
using namespace scripting;
using namespace plugin;
using namespace marsh;
}  // namespace detail
}  // namespace RTT

/** The name of this namespace before version 2. */
namespace Orocos {
using namespace RTT;
}

#endif
