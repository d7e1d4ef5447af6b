// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Plugin `rosdeployment`: a deployer that is used by ROS services ~<deployer>/eval, run_script and get_peer_list. Any
// program that reaches the node can execute code by them.
#include <ocl/DeploymentComponent.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/Service.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/plugin/Plugin.hpp>
#include <rtt_ros/node.hpp>
#include <rtt_ros/rtt_ros.h>
#include <rtt_roscomm/rtt_rosservice_proxy.h>
#include <rtt_roscomm/service_server.hpp>
#include <rtt_ros_msgs/Eval.h>
#include <rtt_ros_msgs/GetPeerList.h>
#include <rtt_ros_msgs/RunScript.h>

#include <array>
#include <cstddef>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

using RTT::endlog;
using RTT::log;

typedef std::vector<std::string> Names;

class Deployment : public RTT::Service {
public:
    explicit Deployment(OCL::DeploymentComponent& deployer)
        : RTT::Service("rosdeployment", &deployer), deployer_(deployer) {
        doc("Executes code and scripts in the deployer, for programs of ROS.");
        addOperation("eval", &Deployment::eval, this, RTT::OwnThread)
            .doc("Executes code of the scripting language. False if it has errors or fails.")
            .arg("code", "statements");
        addOperation("runScript", &Deployment::runScript, this, RTT::OwnThread)
            .doc("Executes a script. False if it cannot be read, or fails.")
            .arg("file", "a .ops, .osd or .lua file");
        addOperation("getPeerList", &Deployment::peers, this, RTT::OwnThread).doc("Names of the deployer's peers.");
        bind(eval_, "eval");
        bind(run_script_, "runScript");
        bind(peers_, "getPeerList");
    }

    /** False, with an error logged, if a service cannot be offered. */
    bool offer() {
        using namespace rtt_ros_msgs;
        const bool isOffered =
            serve<Eval>(0, "eval", "eval",
                        [eval = eval_](const Eval::Request& request, Eval::Response& response) mutable {
                            response.success = eval(request.code);
                            return true;
                        }) &&
            serve<RunScript>(1, "run_script", "runScript",
                             [run = run_script_](const RunScript::Request& request, RunScript::Response& response) mutable {
                                 response.success = run(request.file_path);
                                 return true;
                             }) &&
            serve<GetPeerList>(2, "get_peer_list", "getPeerList",
                               [list = peers_](const GetPeerList::Request&, GetPeerList::Response& response) mutable {
                                   response.peers = list();
                                   return true;
                               });
        return isOffered;
    }

private:
    /** Called by a thread of ROS, executed in that of the deployer. */
    template <class Caller>
    void bind(Caller& caller, const char* operation) {
        caller = Caller(getOperation(operation), RTT::internal::GlobalEngine::Instance());
    }
    template <class SRV, class Function>
    bool serve(std::size_t number, const std::string& name, const std::string& operation, Function function) {
        const boost::shared_ptr<rtt_roscomm::ServiceAnswer> answer(new rtt_roscomm::FunctionAnswer<SRV>(
            "operation '" + operation + "' of '" + deployer_.getName() + "'", *getOperation(operation),
            std::move(function)));
        return servers_.at(number).advertise("~" + deployer_.getName() + '/' + name,
                                             rtt_roscomm::serviceTypeOf<SRV>(), answer);
    }

    bool eval(const std::string& code) {
        if (!deployer_.provides()->hasService("scripting") && !deployer_.loadService("scripting")) return false;
        RTT::OperationCaller<bool(const std::string&)> scripting(
            deployer_.provides("scripting")->getOperation("eval"));
        return scripting.ready() && scripting(code);
    }
    bool runScript(const std::string& file) { return deployer_.runScript(file); }
    Names peers() { return deployer_.getPeerList(); }

    OCL::DeploymentComponent& deployer_;
    RTT::OperationCaller<bool(const std::string&)> eval_, run_script_;
    RTT::OperationCaller<Names()> peers_;
    std::array<rtt_roscomm::ServedService, 3> servers_;
};

bool refuse(const std::string& why) {
    log(RTT::Error) << "service rosdeployment: " << why << endlog();
    return false;
}

bool loadInto(RTT::TaskContext& component) {
    auto* const deployer = dynamic_cast<OCL::DeploymentComponent*>(&component);
    if (!deployer) return refuse("'" + component.getName() + "' is no deployer, and only a deployer can load it");
    if (deployer->provides()->hasService("rosdeployment")) return true;
    std::string why;
    if (!rtt_ros::import("rtt_rosnode")) return refuse("rtt_rosnode cannot be imported");
    if (!rtt_ros::isNodeReady(why)) return refuse(why);
    try {
        const boost::shared_ptr<Deployment> service(new Deployment(*deployer));
        return service->offer() && deployer->provides()->addService(service);
    } catch (const std::exception& thrown) {
        return refuse(thrown.what());  // the name of the deployer cannot be one of ROS
    }
}

}  // namespace

extern "C" {

RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) { return !component || loadInto(*component); }
RTT_EXPORT std::string getRTTPluginName() { return "rosdeployment"; }
RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }
}
