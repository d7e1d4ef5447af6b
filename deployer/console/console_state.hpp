// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all commands of one console share.
#ifndef OROFORGE_CONSOLE_SESSION_HPP
#define OROFORGE_CONSOLE_SESSION_HPP

#include "macro.hpp"
#include "place.hpp"
#include "program_listing.hpp"
#include "screen.hpp"
#include "watch.hpp"

#include <rtt/scripting/typed_input.hpp>

#include <memory>
#include <string>

namespace OCL::console {

struct Session {
    Screen screen;
    RTT::TaskContext& self;  ///< the console's own component
    Place place;
    std::string inputName;  ///< of where lines come from, for messages
    std::unique_ptr<Watch> watch = {};
    std::unique_ptr<RTT::scripting::TypedInput> typed = {};
    ProgramListing listing = {};
    Macro macro = {};
    bool quits = false;

    /** What names are looked up in: the component that is visited, or while it is watched the console's own. Null if it is
        gone. */
    RTT::TaskContext* context() const { return watch ? &self : place.component(); }
    /** To be called after each change of the context. */
    void forgetInput() { typed.reset(); }
    void goTo(bool watching);
};

}  // namespace OCL::console

#endif
