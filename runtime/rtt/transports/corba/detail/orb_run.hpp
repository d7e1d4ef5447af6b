// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_ORB_RUN_HPP
#define ORO_CORBA_DETAIL_ORB_RUN_HPP

namespace RTT {
namespace corba {
namespace detail {

/** The ORB serves calls as long as it exists; these only tell a program how long that should be. */

/** Blocks until somebody calls endRun(), or, if it is not negative, until the descriptor can be read. */
void waitForEndOfRun(int descriptor);
/** Lets all of them return, also later ones. Any thread may call it. */
void endRun();
/** For a new ORB. */
void beginRun();

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
