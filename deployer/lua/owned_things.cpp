// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "owned_things.hpp"

#include <algorithm>

namespace OCL::lua {

OwnedThings::~OwnedThings() {
    std::vector<Thing> left;
    for (auto& thing : things_) left.push_back(std::move(thing.second));
    things_.clear();
    std::sort(left.begin(), left.end(), [](const Thing& a, const Thing& b) { return a.number > b.number; });
    for (Thing& thing : left) released(thing)();
    for (const Destroy& destroy : unused_) destroy();
}

std::shared_ptr<const bool> OwnedThings::keep(const void* thing, Destroy destroy) {
    auto exists = std::make_shared<bool>(true);
    things_[thing] = {std::move(destroy), {}, exists, ++made_, false};
    return exists;
}

OwnedThings::Destroy OwnedThings::released(Thing& thing) {
    *thing.exists = false;
    if (thing.leave) thing.leave();
    return std::move(thing.destroy);
}

void OwnedThings::use(const void* thing, std::function<void()> leave) {
    const auto found = things_.find(thing);
    if (found != things_.end()) found->second.leave = std::move(leave);
}

bool OwnedThings::isUsed(const void* thing) const {
    const auto found = things_.find(thing);
    return found != things_.end() && found->second.leave;
}

void OwnedThings::unuse(const void* thing) {
    use(thing, {});
    const auto found = things_.find(thing);
    if (found != things_.end() && found->second.forgotten) forget(thing);
}

OwnedThings::Destroy OwnedThings::take(const void* thing) {
    const auto found = things_.find(thing);
    if (found == things_.end()) return {};
    Destroy destroy = released(found->second);
    things_.erase(found);
    return destroy;
}

void OwnedThings::forget(const void* thing) {
    const auto found = things_.find(thing);
    if (found == things_.end()) return;
    found->second.forgotten = true;
    if (found->second.leave) return;
    unused_.push_back(released(found->second));
    things_.erase(found);
}

std::vector<OwnedThings::Destroy> OwnedThings::takeUnused() {
    std::vector<Destroy> taken;
    taken.swap(unused_);
    return taken;
}

}  // namespace OCL::lua
