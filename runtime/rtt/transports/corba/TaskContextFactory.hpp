// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_TASK_CONTEXT_FACTORY_HPP
#define ORO_CORBA_TASK_CONTEXT_FACTORY_HPP

#include <rtt/rtt-config.h>

#include <string>

namespace RTT {
class TaskContext;
namespace corba {

/**
 * Components of other processes, for code that knows nothing of the ORB. Any thread may call these functions. They call
 * other processes, block for that, and log what fails.
 */
class RTT_API TaskContextFactory {
public:
    /** As ApplicationServer::InitOrb(). */
    static bool InitOrb(int argc, char* argv[]);
    static void DestroyOrb();

    /** As the functions of TaskContextProxy with these names: null, with an error logged, if there is no proxy. */
    static TaskContext* Create(std::string name, bool is_ior = false);
    static TaskContext* CreateFromFile(std::string filename);
};

}  // namespace corba
}  // namespace RTT

#endif
