// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The contents of a package: plain data with its places in the manifest. No XML, no generated text.
#ifndef OROFORGE_GENERATOR_MODEL_PACKAGE_HPP
#define OROFORGE_GENERATOR_MODEL_PACKAGE_HPP

#include <optional>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>

namespace oroforge::model {

/// A text of the user with its place. Empty and without line if it was not given.
struct Text {
    std::string value;
    diag::Location where;

    bool given() const { return where.line != 0; }
};

/// A number of the user: as it was written, and its value.
struct Number {
    std::string text;
    double value = 0;
    diag::Location where;
};

enum class Direction { In, Out };
enum class Thread { Client, Own };
enum class ActivityKind { Periodic, NonPeriodic, Sequential, Slave };
/// Of each kind, in the manifest.
inline constexpr const char* kActivityWords[] = {"periodic", "nonperiodic", "sequential", "slave"};
inline std::string word(ActivityKind kind) { return kActivityWords[static_cast<std::size_t>(kind)]; }

enum class InitialState { PreOperational, Stopped };

/// The connection policy that a port proposes.
struct Policy {
    std::string type;  ///< "data", "buffer" or "circular_buffer"
    std::optional<Number> size;
    std::string lock;  ///< "lock_free", "locked", "unsync" or empty
    bool init = false;
    bool pull = false;
    diag::Location where;
};

struct Port {
    Text name;
    Direction direction = Direction::In;
    Text type;
    bool event = false;
    diag::Location eventWhere;
    std::optional<Policy> policy;
    std::string doc;
    diag::Location where;
};

/// A property or an attribute.
struct Value {
    Text name;
    Text type;
    Text defaultValue;
    std::optional<Number> minimum;
    std::optional<Number> maximum;
    std::string unit;
    std::string doc;
    diag::Location where;
};

struct Property : Value {};

/// Without description in the runtime. A constant keeps its default.
struct Attribute : Value {
    bool constant = false;
};

struct Argument {
    Text name;
    Text type;
    std::string unit;
    std::string doc;
    diag::Location where;
};

struct Operation {
    Text name;
    Text returns;  ///< "void" if not given
    Thread thread = Thread::Client;
    std::vector<Argument> arguments;
    std::string doc;
    diag::Location where;
};

struct Service;

/// What others see of a component or a service.
struct Interface {
    std::vector<Port> ports;
    std::vector<Property> properties;
    std::vector<Attribute> attributes;
    std::vector<Operation> operations;
    std::vector<Service> services;
};

/// A named part of a component's interface; services can have services.
struct Service : Interface {
    Text name;
    std::string doc;
    diag::Location where;
};

/// A service of a peer that a component calls.
struct Requirement {
    Text name;
    std::vector<Operation> operations;
    std::string doc;
    diag::Location where;
};

struct Activity {
    ActivityKind kind = ActivityKind::NonPeriodic;
    std::optional<Number> period;  ///< seconds
    std::optional<Number> priority;
    Text scheduler;  ///< "ORO_SCHED_RT" or "ORO_SCHED_OTHER"
    diag::Location where;
};

/// The hooks that the user's class overrides.
struct Hooks {
    bool configure = true;
    bool start = true;
    bool update = true;
    bool stop = true;
    bool cleanup = true;
    bool error = false;
    bool exception = false;
};

struct Hook {
    const char* name;  ///< in the manifest; the method is NAMEHook()
    bool Hooks::*wanted;
    const char* returns;
};

/// In the order in which classes declare them.
inline constexpr Hook kHooks[] = {{"configure", &Hooks::configure, "bool"}, {"start", &Hooks::start, "bool"},
                                  {"update", &Hooks::update, "void"},       {"error", &Hooks::error, "void"},
                                  {"exception", &Hooks::exception, "void"}, {"stop", &Hooks::stop, "void"},
                                  {"cleanup", &Hooks::cleanup, "void"}};

struct Component : Interface {
    Text className;  ///< qualified: "tank::Controller"
    InitialState initial = InitialState::Stopped;
    std::optional<Activity> activity;  ///< the runtime's default if not given
    std::string doc;
    std::vector<Requirement> required;
    Hooks hooks;
    bool dynamic = false;  ///< adds more ports or properties at run time
    diag::Location where;
};

/// A service in its own library, which components load by name.
struct ServicePlugin : Interface {
    Text name;
    Text className;  ///< qualified: "tank::Recorder"
    std::string doc;
    diag::Location where;
};

/// Code in its own library that runs when it is loaded, into a component or into the process.
struct Plugin {
    Text name;
    std::string doc;
    diag::Location where;
};

struct Person {
    Text name;
    Text email;
};

enum class SkeletonKind { Component, Topics, Plugin, Service, Support, Application };

/// A part of a package that is written once from a template; no manifest describes it.
struct Skeleton {
    SkeletonKind kind = SkeletonKind::Component;
    std::string name;       ///< of its library or program, and part of its file names
    std::string className;  ///< qualified; for components and services
};

struct Package {
    Text name;
    Text version;
    Text license;
    std::string description;
    std::vector<Person> maintainers;
    std::vector<Person> authors;
    std::vector<Text> dependencies;    ///< names of packages
    std::vector<Text> typekitHeaders;  ///< relative to the package: "include/tank/tank-types.hpp"
    std::vector<Component> components;
    std::vector<ServicePlugin> services;
    std::vector<Plugin> plugins;
    std::vector<Skeleton> skeletons;
    diag::Location where;
};

/// Returns the model as JSON text, for --dump=model and goldens; named items have their lines and columns.
std::string dump(const Package& package);

}  // namespace oroforge::model

#endif
