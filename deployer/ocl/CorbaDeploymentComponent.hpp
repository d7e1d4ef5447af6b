// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DEPLOYMENT_COMPONENT_HPP
#define ORO_CORBA_DEPLOYMENT_COMPONENT_HPP

#include <ocl/DeploymentComponent.hpp>

namespace OCL {

/**
 * A deployer whose components other processes can use, and which can use theirs. The ORB must exist:
 * RTT::corba::TaskContextServer::InitOrb().
 *
 * In files, `Server` makes a component callable, by the naming service unless `UseNamingService` is false. Components
 * of other processes have the types `CORBA` or `TaskContextProxy`, named as in the naming service; `IORFile`, named
 * after the file with their reference; or `IOR`, named by the reference itself. Those of the last two types are peers
 * under their own name, too. Their end here leaves them as they are.
 */
class OCL_API CorbaDeploymentComponent : public DeploymentComponent {
public:
    explicit CorbaDeploymentComponent(const std::string& name, const std::string& siteFile = std::string(),
                                      Purpose purpose = Purpose::Deploy);
    /** Unloads all components before their servers end. */
    ~CorbaDeploymentComponent() override;

    /** Lets other processes use a peer. Calls the naming service, for which it blocks. */
    bool createServer(const std::string& tc, bool use_naming);
    /** The same under another name. */
    bool createServerAlias(const std::string& tc, const std::string& alias, bool use_naming);

protected:
    /** Ends the server of a component. */
    void componentUnloaded(RTT::TaskContext* component) override;
};

}  // namespace OCL

#endif
