// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UPDATE_STUB_PORT_HPP
#define OROFORGE_TESTS_UPDATE_STUB_PORT_HPP

namespace RTT {

template <class T>
class OutputPort {};

}  // namespace RTT

#endif
