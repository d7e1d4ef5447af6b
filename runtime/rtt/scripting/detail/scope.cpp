// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compiler.hpp>

namespace RTT {
namespace scripting {
namespace detail {

const Scope::Entry* Scope::find(const std::string& name) const {
    for (const Scope* scope = this; scope; scope = scope->parent_)
        if (const Entry* const found = scope->findHere(name)) return found;
    return nullptr;
}

const Scope::Entry* Scope::findHere(const std::string& name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? nullptr : &found->second;
}

bool Scope::add(const std::string& name, Entry entry) { return entries_.emplace(name, std::move(entry)).second; }

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
