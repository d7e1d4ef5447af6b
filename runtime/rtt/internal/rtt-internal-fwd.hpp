// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of implementation classes that user code names.
#ifndef ORO_RTT_INTERNAL_FWD_HPP
#define ORO_RTT_INTERNAL_FWD_HPP

namespace RTT {
namespace internal {
class ConnectionManager;
class ConnFactory;
class ConnID;
class GlobalEngine;
class GlobalService;
class LocalConnID;
class OperationCallerC;
class SendHandleC;
class SharedConnectionBase;
class SignalBase;
class StreamConnID;
struct GenerateDataSource;
template <typename T>
class DataSource;
template <typename T>
class AssignableDataSource;
template <typename T>
class ValueDataSource;
template <typename T>
class ConstantDataSource;
template <typename T>
class ReferenceDataSource;
template <typename T>
class ConstReferenceDataSource;
template <typename T>
class PartDataSource;
template <typename T, typename S>
class AssignCommand;
template <class T>
struct DataSourceTypeInfo;
template <class Signature>
class LocalOperationCaller;
template <class Signature>
class Signal;
}  // namespace internal
}  // namespace RTT

#endif
