// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A CORBA::Any as another process gets it.
#ifndef OROFORGE_TESTS_ANY_WIRE_HPP
#define OROFORGE_TESTS_ANY_WIRE_HPP

#include <omniORB4/CORBA.h>

#include <memory>

namespace corba_test {

/// The ORB of the test; there is one per process.
inline CORBA::ORB_ptr orb() {
    static int argc = 0;
    static const CORBA::ORB_var made = CORBA::ORB_init(argc, nullptr);
    return made.in();
}

/// Written into a message, after a byte so that nothing is aligned by chance, and read from it.
inline std::unique_ptr<CORBA::Any> sent(const CORBA::Any& any, bool asLittleEndian) {
    cdrMemoryStream message;
    message.setByteSwapFlag(asLittleEndian);
    message.marshalOctet(1);
    any >>= message;
    message.rewindInputPtr();
    auto back = std::make_unique<CORBA::Any>();
    (void)message.unmarshalOctet();
    *back <<= message;
    return back;
}

}  // namespace corba_test

#endif
