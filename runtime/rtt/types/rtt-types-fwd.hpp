// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of the type system.
#ifndef ORO_RTT_TYPES_FWD_HPP
#define ORO_RTT_TYPES_FWD_HPP

namespace RTT {
namespace types {
class CompositionFactory;
class GlobalsRepository;
class MemberFactory;
class OperatorRepository;
class StreamFactory;
class TransportPlugin;
class TypeConstructor;
class TypeInfo;
class TypeInfoGenerator;
class TypeInfoRepository;
class TypekitPlugin;
class TypekitRepository;
class TypeMarshaller;
class TypeTransporter;
class ValueFactory;
template <typename T>
class carray;
}  // namespace types
}  // namespace RTT

#endif
