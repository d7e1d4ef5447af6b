// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component that the user visits, reached from another one along peers.
#ifndef OROFORGE_CONSOLE_PLACE_HPP
#define OROFORGE_CONSOLE_PLACE_HPP

#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <string>
#include <vector>

namespace OCL::console {

/** The letter of the state of a component: Fatal error, run time Error, eXception, Running, Stopped or Unconfigured. */
char stateLetter(RTT::TaskContext& component);

/** A component or service that a path leads to. */
struct Target {
    RTT::TaskContext* component = nullptr;  ///< null for a service
    RTT::Service::shared_ptr service;       ///< the main one of a component; null if nothing was found
    std::string name;                       ///< the last part of the path
};

/**
 * The result of following peers and services from a component along `path`, "a.b.c"; an empty one leads to the
 * component. If the path leads nowhere, `wrong` is its first unknown part and `known` are the names that may replace
 * it.
 */
struct Lookup {
    Target target;
    std::string wrong;
    std::size_t wrongAt = 0;  ///< in the path
    std::vector<std::string> known;
};
Lookup lookUp(RTT::TaskContext& from, const std::string& path);

/** Removes the dot that completion adds after a component or service. */
inline std::string withoutLastDot(const std::string& path) {
    return !path.empty() && path.back() == '.' ? path.substr(0, path.size() - 1) : path;
}

/** The parts of "a.b.c". */
std::vector<std::string> partsOf(const std::string& path);

/** The present visit and those before it. Components are looked up by name each time, because they may be destroyed. */
class Place {
public:
    explicit Place(RTT::TaskContext& root);

    /** The visited component; null if it is gone, see back(). */
    RTT::TaskContext* component() const;
    /** The name of the component, even if it is gone. */
    const std::string& name() const { return here_.name; }
    /** Visits a peer of the present component, or one of its peers; an empty path leads back to the first component.
        False if the path leads nowhere. */
    bool visit(const std::string& path);
    void visit(RTT::TaskContext& root);
    /** Returns to the latest visited component that still exists; false if there is none. */
    bool back();

private:
    struct Visit {
        RTT::TaskContext* root;
        boost::intrusive_ptr<const RTT::internal::EngineGate> gate;  ///< closed when the root is destroyed
        std::vector<std::string> peers;                              ///< the path from the root
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
