// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component that the user visits, reached from another one along peers.
#ifndef OROFORGE_CONSOLE_PLACE_HPP
#define OROFORGE_CONSOLE_PLACE_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/dotted_name.hpp>

#include <string>
#include <vector>

namespace OCL::console {

/** The letter of the state of a component: Fatal error, run time Error, eXception, Running, Stopped or Unconfigured. */
char stateLetter(RTT::TaskContext& component);

using RTT::internal::NamedObject;
using RTT::internal::ResolvedName;

/** Removes the dot that completion adds after a component or service. */
inline std::string withoutLastDot(const std::string& path) {
    return !path.empty() && path.back() == '.' ? path.substr(0, path.size() - 1) : path;
}

/** The present visit and those before it. Components are looked up by name each time, because they may be destroyed. */
class Place {
public:
    explicit Place(RTT::TaskContext& root);

    /** The visited component; null if it is gone, see back(). */
    RTT::TaskContext* component() const;
    /** The component from which the path of the visited one begins, and that of the earliest visit. */
    std::vector<boost::intrusive_ptr<const RTT::internal::EngineGate>> roots() const;
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
