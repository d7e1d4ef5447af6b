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
#include <rtt_ros_msgs/Eval.h>
#include <rtt_ros_msgs/GetPeerList.h>
#include <rtt_ros_msgs/RunScript.h>

#include <ros/node_handle.h>

#include <exception>
#include <string>
#include <vector>

namespace {

using RTT::endlog;
using RTT::log;

typedef std::vector<std::string> Names;

class Deployment : public RTT::Service {
public:
    explicit Deployment(OCL::DeploymentComponent& deployer)
        : RTT::Service("rosdeployment", &deployer), deployer_(deployer), node_("~" + deployer.getName()) {
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
        servers_ = {node_.advertiseService("eval", &Deployment::onEval, this),
                    node_.advertiseService("run_script", &Deployment::onRunScript, this),
                    node_.advertiseService("get_peer_list", &Deployment::onGetPeerList, this)};
    }
    ~Deployment() override {
        for (ros::ServiceServer& server : servers_) server.shutdown();
    }

private:
    /** Called by a thread of ROS, executed in that of the deployer. */
    template <class Caller>
    void bind(Caller& caller, const char* operation) {
        caller = Caller(getOperation(operation), RTT::internal::GlobalEngine::Instance());
    }

    bool eval(const std::string& code) {
        if (!deployer_.provides()->hasService("scripting") && !deployer_.loadService("scripting")) return false;
        RTT::OperationCaller<bool(const std::string&)> scripting(
            deployer_.provides("scripting")->getOperation("eval"));
        return scripting.ready() && scripting(code);
    }
    bool runScript(const std::string& file) { return deployer_.runScript(file); }
    Names peers() { return deployer_.getPeerList(); }

    /** Returns false, which fails the call of the service, if the deployer does not answer, as at its end. */
    template <class Call>
    bool answered(const char* service, Call call) {
        try {
            call();
            return true;
        } catch (const std::exception& thrown) {
            log(RTT::Error) << "service " << service << " of ROS: " << thrown.what() << endlog();
        } catch (...) {
            log(RTT::Error) << "service " << service << " of ROS: an unknown exception was thrown" << endlog();
        }
        return false;
    }
    bool onEval(rtt_ros_msgs::Eval::Request& request, rtt_ros_msgs::Eval::Response& response) {
        return answered("eval", [&] { response.success = eval_(request.code); });
    }
    bool onRunScript(rtt_ros_msgs::RunScript::Request& request, rtt_ros_msgs::RunScript::Response& response) {
        return answered("run_script", [&] { response.success = run_script_(request.file_path); });
    }
    bool onGetPeerList(rtt_ros_msgs::GetPeerList::Request&, rtt_ros_msgs::GetPeerList::Response& response) {
        return answered("get_peer_list", [&] { response.peers = peers_(); });
    }

    OCL::DeploymentComponent& deployer_;
    RTT::OperationCaller<bool(const std::string&)> eval_, run_script_;
    RTT::OperationCaller<Names()> peers_;
    ros::NodeHandle node_;
    std::vector<ros::ServiceServer> servers_;
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
        return deployer->provides()->addService(RTT::Service::shared_ptr(new Deployment(*deployer)));
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
