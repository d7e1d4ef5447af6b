// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The contents of a deployment file, as plain data with places. Nothing here refers to live components.
#ifndef OROFORGE_DEPLOYMENT_PLAN_HPP
#define OROFORGE_DEPLOYMENT_PLAN_HPP

#include <rtt/deployment/deployed_texts.hpp>
#include <diag/diagnostic.hpp>
#include <rtt/ConnPolicy.hpp>
#include <xml/element.hpp>

#include <optional>
#include <string>
#include <vector>

namespace OCL::deploy {

namespace diag = oroforge::diag;
namespace xml = oroforge::xml;

/** A word of the file and its place. */
struct Text {
    std::string value;
    diag::Location where;

    bool empty() const { return value.empty(); }
};

/** A flag that may have been left out. */
using Flag = std::optional<bool>;

struct ImportPlan {
    enum Kind { Import, Path, LoadLibrary } kind = Import;
    Text what;
};

struct PolicyPlan {
    Text name;  // the connection
    RTT::ConnPolicy policy;
};

enum class ActivityKind { Activity, NonPeriodic, Periodic, Slave, Sequential, FileDescriptor };

struct ActivityPlan {
    ActivityKind kind = ActivityKind::Activity;
    std::string type;  // as written
    diag::Location where;
    std::optional<double> period;  // seconds; for a FileDescriptorActivity the timeout in milliseconds
    std::optional<int> priority;
    bool realTime = true;  // ORO_SCHED_RT
    std::optional<unsigned> cpuAffinity;
    Text master;
};

struct PropertyFilePlan {
    enum Mode { Strict, Update, Load } mode = Strict;  // PropertyFile, UpdateProperties, LoadProperties
    Text file;
};

struct ScriptPlan {
    enum Kind { Run, Program, StateMachine } kind = Run;
    Text file;
};

struct PortPlan {
    Text port;
    Text connection;
};

struct ComponentPlan {
    Text name;
    Text type;
    Flag autoConf, autoStart, autoConnect, autoSave;
    Flag server, useNamingService;
    diag::Location serverWhere;
    std::vector<Text> services;
    std::vector<xml::Element> properties;  // `Properties` structs; the component has their types
    std::vector<PropertyFilePlan> propertyFiles;
    std::vector<PortPlan> ports;
    std::vector<Text> peers;
    std::vector<Text> members;  // of a chain, in their order
    std::vector<ScriptPlan> scripts;
    std::optional<ActivityPlan> activity;
    // By a recording, see replaced.hpp.
    bool isReplaced = false, isReplacedWithoutInput = false;
};

/** A file with everything it includes. Imports precede components, whatever their order in the file. */
struct Plan {
    std::string file;
    std::vector<ImportPlan> imports;
    std::vector<PolicyPlan> policies;
    std::optional<RTT::ConnPolicy> defaultPolicy;  // for the process from now on
    std::vector<ComponentPlan> components;
    std::vector<xml::Element> globals;             // `Properties` structs for the global properties
    std::vector<RTT::plugin::DeployedText> texts;  // of the file and those that it includes
};

}  // namespace OCL::deploy

#endif
