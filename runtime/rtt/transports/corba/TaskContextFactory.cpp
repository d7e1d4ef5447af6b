// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/TaskContextFactory.hpp>

#include <rtt/transports/corba/TaskContextProxy.hpp>

#include <utility>

namespace RTT::corba {

bool TaskContextFactory::InitOrb(int argc, char* argv[]) { return ApplicationServer::InitOrb(argc, argv); }
void TaskContextFactory::DestroyOrb() { TaskContextProxy::DestroyOrb(); }

TaskContext* TaskContextFactory::Create(std::string name, bool is_ior) {
    return TaskContextProxy::Create(std::move(name), is_ior);
}
TaskContext* TaskContextFactory::CreateFromFile(std::string filename) {
    return TaskContextProxy::CreateFromFile(std::move(filename));
}

}  // namespace RTT::corba
