// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_SOCKETS_HPP
#define OROFORGE_LIVE_SOCKETS_HPP

#include <string>

namespace OCL::live {

/** Of the other end: "127.0.0.1:51234" */
std::string addressOf(int socket);
/** AF_UNIX, AF_INET … */
int familyOf(int socket);
/** Sends small messages at once, and notices that a computer has gone without a word. */
void keepAlive(int socket);
/** The number of an error says that the process, or the system, has no more files or memory. */
bool isExhaustion(int error);

}  // namespace OCL::live

#endif
