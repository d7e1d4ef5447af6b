// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_KEY_VALUE_HPP
#define ORO_KEY_VALUE_HPP

namespace RTT {
namespace types {

/** An entry of a map, as scripts and property files see it. */
template <class K, class V>
struct KeyValue {
    K key{};
    V value{};
};

}  // namespace types
}  // namespace RTT

#endif
