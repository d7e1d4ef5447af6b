// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where the user is: a component, reached from another one along peers.
#ifndef OROFORGE_CONSOLE_PLACE_HPP
#define OROFORGE_CONSOLE_PLACE_HPP

#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/EngineGate.hpp>

#include <string>
#include <vector>

namespace OCL::console {

/** The letter that stands for the state of a component: Fatal error, run time Error, eXception, Running, Stopped, or
    Unconfigured. */
char stateLetter(RTT::TaskContext& component);

/** A component or service that a path leads to. */
struct Target {
    RTT::TaskContext* component = nullptr;  ///< null: it is a service
    RTT::Service::shared_ptr service;       ///< of a component, its main one; null if there is no such thing
    std::string name;                       ///< the last part of the path
};

/** Follows peers and services from a component along `path`, "a.b.c"; an empty one leads to itself. If there is no such thing,
    `wrong` is the part that is none, and `known` what could stand in its place. */
struct Lookup {
    Target target;
    std::string wrong;
    std::size_t wrongAt = 0;  ///< in the path
    std::vector<std::string> known;
};
Lookup lookUp(RTT::TaskContext& from, const std::string& path);

/** Completion leaves a dot behind a component or service, where the path could go on. */
inline std::string withoutLastDot(const std::string& path) {
    return !path.empty() && path.back() == '.' ? path.substr(0, path.size() - 1) : path;
}

/** The parts of "a.b.c". */
std::vector<std::string> partsOf(const std::string& path);

/** A visit, with those before it. Components are looked up each time by their names: they may be gone any time. */
class Place {
public:
    explicit Place(RTT::TaskContext& root);

    /** Null if it is gone, see back(). */
    RTT::TaskContext* component() const;
    /** Of the component, as it was. */
    const std::string& name() const { return here_.name; }
    /** A peer of the present one, or one of its peers; an empty path leads to where the console began. False if there is none. */
    bool visit(const std::string& path);
    void visit(RTT::TaskContext& root);
    /** To the one visited before that is still there; false if there is none. */
    bool back();

private:
    struct Visit {
        RTT::TaskContext* root;
        boost::intrusive_ptr<const RTT::internal::EngineGate> gate;  ///< closed once the root is destroyed
        std::vector<std::string> peers;                              ///< the way from the root
        std::string name;
    };
    static Visit visitOf(RTT::TaskContext& root);
    static RTT::TaskContext* find(const Visit& visit);
    void go(Visit to);

    Visit here_;
    std::vector<Visit> before_;
};

}  // namespace OCL::console

#endif
