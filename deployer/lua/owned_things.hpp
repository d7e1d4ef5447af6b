// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_OWNED_THINGS_HPP
#define OCL_LUA_OWNED_THINGS_HPP

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace OCL::lua {

/** The ports, properties and attributes that Lua code made. A component may refer to one that no Lua code knows any
    more. What is left is destroyed with the state, the newest first. */
class OwnedThings {
public:
    typedef std::function<void()> Destroy;

    OwnedThings() = default;
    ~OwnedThings();
    OwnedThings(const OwnedThings&) = delete;
    OwnedThings& operator=(const OwnedThings&) = delete;

    /** Takes ownership. The result is true as long as the thing exists. */
    template <class Thing>
    std::shared_ptr<const bool> add(Thing* thing) {
        return keep(thing, [thing] { delete thing; });
    }
    /** A component refers to it from now on; `leave` ends that before it is destroyed. Ignores what it does not own. */
    void use(const void* thing, std::function<void()> leave);
    bool isUsed(const void* thing) const;
    /** No component refers to it any more. */
    void unuse(const void* thing);
    /** Gives it to the caller, which destroys it by calling the result; empty if it is not owned. */
    Destroy take(const void* thing);
    /** A component has this copy of a thing that Lua code gave to it. */
    void give(const void* copy) { given_.insert(copy); }
    /** True, once, if it is such a copy. */
    bool takeGiven(const void* copy) { return given_.erase(copy) != 0; }
    /** No Lua code knows it any more. */
    void forget(const void* thing);
    /** Those that neither Lua code nor a component uses, to be destroyed by the caller. */
    std::vector<Destroy> takeUnused();
    std::size_t unused() const { return unused_.size(); }

private:
    struct Thing {
        Destroy destroy;
        std::function<void()> leave;
        std::shared_ptr<bool> exists;
        unsigned long number;
        bool forgotten = false;
    };
    std::shared_ptr<const bool> keep(const void* thing, Destroy destroy);
    static Destroy released(Thing& thing);
    std::map<const void*, Thing> things_;
    std::set<const void*> given_;
    std::vector<Destroy> unused_;
    unsigned long made_ = 0;
};

}  // namespace OCL::lua

#endif
