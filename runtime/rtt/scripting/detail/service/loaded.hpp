// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The contents of a scripting service: programs and state machines by name, and definitions of scripts.
#ifndef ORO_SCRIPTING_DETAIL_LOADED_HPP
#define ORO_SCRIPTING_DETAIL_LOADED_HPP

#include <rtt/Property.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/compile/definitions.hpp>

#include <boost/shared_ptr.hpp>
#include <boost/weak_ptr.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace RTT::scripting {

namespace detail {

/** Items by name. Thread safe. */
template <class T>
class Registry {
public:
    typedef boost::shared_ptr<T> Pointer;

    void add(const std::string& name, Pointer item) {
        const std::lock_guard<std::mutex> lock(mutex_);
        items_[name] = std::move(item);
    }
    void remove(const std::string& name) {
        const std::lock_guard<std::mutex> lock(mutex_);
        items_.erase(name);
    }
    /** The item of that name; null if there is none. */
    Pointer find(const std::string& name) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto found = items_.find(name);
        return found == items_.end() ? nullptr : found->second;
    }
    /** Calls a function of the item and returns the result; `otherwise` if there is no such item. */
    template <class Result, class Function>
    Result ask(const std::string& name, Result otherwise, Function function) const {
        const Pointer item = find(name);
        return item ? std::invoke(function, *item) : otherwise;
    }
    /** All names in alphabetical order. */
    std::vector<std::string> names() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        std::vector<std::string> names;
        for (const auto& item : items_) names.push_back(item.first);
        return names;
    }

private:
    mutable std::mutex mutex_;
    std::map<std::string, Pointer> items_;
};

/** Items that were unloaded and may still be executed; they refer to themselves as long as they are. Thread safe. */
class Retired {
public:
    typedef boost::shared_ptr<base::ExecutableInterface> Pointer;

    void add(Pointer item) {
        const std::lock_guard<std::mutex> lock(mutex_);
        items_.push_back(std::move(item));
    }
    /** Keeps an item that does not refer to itself, for ever, because the end of its execution is unknown. */
    void keep(Pointer item) {
        const std::lock_guard<std::mutex> lock(mutex_);
        kept_.push_back(std::move(item));
    }
    /** Destroys items without other references. May be called within a step, because the engine does not use items that
        were removed from it. */
    void dropUnused() {
        // Destroyed without the lock, because that may unload other items; repeated, because these may have owned
        // others.
        for (std::vector<Pointer> unused = takeUnused(); !unused.empty(); unused = takeUnused()) unused.clear();
    }

private:
    std::vector<Pointer> takeUnused() {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto used =
            std::partition(items_.begin(), items_.end(), [](const Pointer& item) { return item.use_count() > 1; });
        std::vector<Pointer> unused(std::make_move_iterator(used), std::make_move_iterator(items_.end()));
        items_.erase(used, items_.end());
        return unused;
    }

    std::mutex mutex_;
    std::vector<Pointer> items_, kept_;
};

}  // namespace detail

struct ScriptingService::Loaded {
    explicit Loaded(boost::weak_ptr<Service> of) : component(std::move(of)) {}

    const boost::weak_ptr<Service> component;  ///< has an owner unless that is being destroyed
    detail::Registry<ProgramInterface> programs;
    detail::Registry<StateMachine> machines;  ///< the root machines, and machines below them as "root.sub"
    detail::Definitions definitions;
    Property<unsigned int> stepBudget{
        "StepBudget", "How often loops of a program, function or state machine may go round in one step; 0: no limit.",
        0u};

    boost::intrusive_ptr<internal::DataSource<unsigned int>> roundLimit() const {
        return stepBudget.getAssignableDataSource();
    }
    detail::Retired retired;
};

}  // namespace RTT::scripting

#endif
