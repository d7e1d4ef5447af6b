// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "place.hpp"

#include <rtt/internal/GlobalService.hpp>

#include <algorithm>
#include <utility>

namespace OCL::console {
namespace {

using RTT::TaskContext;

constexpr std::size_t kMostVisits = 20;

}  // namespace

char stateLetter(TaskContext& component) {
    if (component.inFatalError()) return 'F';
    if (component.inRunTimeError()) return 'E';
    if (component.inException()) return 'X';
    if (component.isRunning()) return 'R';
    return component.isConfigured() ? 'S' : 'U';
}

std::vector<std::string> partsOf(const std::string& path) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        parts.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

Lookup lookUp(TaskContext& from, const std::string& path) {
    Lookup result;
    Target here{&from, from.provides(), from.getName()};
    std::size_t at = 0;
    for (const std::string& part : partsOf(path)) {
        const auto global = RTT::internal::GlobalService::Instance();
        TaskContext* const peer = here.component ? here.component->getPeer(part) : nullptr;
        if (at == 0 && (part == "this" || part == "task")) {
            // It is the component itself.
        } else if (peer) {
            here.component = peer;
            here.service = peer->provides();
        } else if (here.service->hasService(part)) {
            here.component = nullptr;
            here.service = here.service->getService(part);
        } else if (at == 0 && part == from.getName()) {
            // Stays at the component.
        } else if (at == 0 && (part == "GlobalService" || global->hasService(part))) {
            here.component = nullptr;
            here.service = part == "GlobalService" ? global : global->getService(part);
        } else {
            result.wrong = part;
            result.wrongAt = at;
            result.known = here.service->getProviderNames();
            if (here.component)
                for (const std::string& peer : here.component->getPeerList()) result.known.push_back(peer);
            return result;
        }
        here.name = part == "this" || part == "task" ? from.getName() : part;
        at += part.size() + 1;
    }
    result.target = here;
    return result;
}

Place::Place(TaskContext& root) : here_(visitOf(root)) {}

Place::Visit Place::visitOf(TaskContext& root) { return {&root, root.engine()->gate(), {}, root.getName()}; }

TaskContext* Place::find(const Visit& visit) {
    if (visit.gate->closed()) return nullptr;
    TaskContext* component = visit.root;
    for (const std::string& peer : visit.peers) {
        component = component->getPeer(peer);
        if (!component) return nullptr;
    }
    return component;
}

TaskContext* Place::component() const { return find(here_); }

void Place::go(Visit to) {
    before_.push_back(std::move(here_));
    if (before_.size() > kMostVisits) before_.erase(before_.begin());
    here_ = std::move(to);
}

bool Place::visit(const std::string& path) {
    Visit next = here_;
    if (path.empty()) next.peers.clear();
    for (const std::string& part : partsOf(path)) next.peers.push_back(part);
    TaskContext* const component = find(next);
    if (!component) return false;
    next.name = component->getName();
    go(std::move(next));
    return true;
}

void Place::visit(TaskContext& root) { go(visitOf(root)); }

bool Place::back() {
    while (!before_.empty()) {
        here_ = std::move(before_.back());
        before_.pop_back();
        if (find(here_)) return true;
    }
    return false;
}

}  // namespace OCL::console
