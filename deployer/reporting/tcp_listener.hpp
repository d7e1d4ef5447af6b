// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TCP_LISTENER_HPP
#define ORO_OCL_REPORTING_TCP_LISTENER_HPP

#include "descriptor.hpp"

#include <string>

namespace OCL::reporting {

/** A socket on which clients may connect. Its functions do not block. */
struct TcpListener {
    Descriptor socket;
    unsigned int port = 0;  ///< the one that is used
};

/**
 * Listens on a port of an address: "127.0.0.1", "::1", "localhost", "0.0.0.0" for all of this computer, … If the port
 * is in use, tries the next four. Port 0 is any free one. If that fails, the socket is empty and `error` says why.
 */
TcpListener listenOn(const std::string& address, unsigned int port, std::string& error);

/** True if only programs of this computer can connect to that address. */
bool isLoopback(const std::string& address);

}  // namespace OCL::reporting

#endif
