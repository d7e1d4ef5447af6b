// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "place.hpp"

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

std::vector<boost::intrusive_ptr<const RTT::internal::EngineGate>> Place::roots() const {
    if (before_.empty()) return {here_.gate};
    return {here_.gate, before_.front().gate};
}

void Place::go(Visit to) {
    before_.push_back(std::move(here_));
    if (before_.size() > kMostVisits) before_.erase(before_.begin());
    here_ = std::move(to);
}

bool Place::visit(const std::string& path) {
    Visit next = here_;
    if (path.empty()) next.peers.clear();
    for (const std::string& part : RTT::internal::partsOf(path)) next.peers.push_back(part);
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
