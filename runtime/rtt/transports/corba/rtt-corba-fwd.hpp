// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations.
#ifndef ORO_RTT_CORBA_FWD_HPP
#define ORO_RTT_CORBA_FWD_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace corba {
class AnyDataSource;
class CRemoteChannelElement_i;
class CorbaOperationCallerFactory;
class CorbaTypeTransporter;
class RemoteInputPort;
class RemoteOutputPort;
class TaskContextFactory;
class TaskContextProxy;
class TaskContextServer;
struct ApplicationServer;
struct CorbaLibPlugin;
struct IllegalServer;
struct NonExistingDataSource;
struct RemoteConnID;
template <class Base>
class RemotePort;
template <class T>
class CorbaTemplateProtocol;
template <class T>
class DataSourceProxy;
template <class T>
class ValueDataSourceProxy;
template <typename T>
class RemoteChannelElement;
template <class T>
struct AnyConversion;
template <class T, class CorbaT>
struct AnyConversionHelper;
}  // namespace corba

namespace detail {
using namespace corba;
}
}  // namespace RTT

#endif
