// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_APPLICATION_SERVER_HPP
#define ORO_CORBA_APPLICATION_SERVER_HPP

#include <rtt/Time.hpp>
#include <rtt/transports/corba/corba.h>

namespace RTT {
namespace corba {

/** The ORB of the process. */
struct RTT_API ApplicationServer {
    static CORBA::ORB_var orb;
    static PortableServer::POA_var rootPOA;

    /**
     * Makes the ORB from arguments such as "-ORBInitRef NameService=…", after which others can call this process. False
     * if there is one already, or, with an error logged, if an argument is wrong. `orb_timeout`: seconds after which
     * every remote call fails, 0 for never. Blocks.
     *
     * Without -ORBendPoint, only processes of this computer can connect, unless the naming service is on another one.
     */
    static bool InitOrb(int argc, char* argv[], Seconds orb_timeout = 0);
};

}  // namespace corba
}  // namespace RTT

#endif
