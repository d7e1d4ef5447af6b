// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a scripting service keeps: programs and state machines by name, and what scripts have defined.
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

/** By name. Thread safe. */
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
    /** Null if there is none. */
    Pointer find(const std::string& name) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto found = items_.find(name);
        return found == items_.end() ? nullptr : found->second;
    }
    /** What a function of the item returns; `otherwise` if there is none. */
    template <class Result, class Function>
    Result ask(const std::string& name, Result otherwise, Function function) const {
        const Pointer item = find(name);
        return item ? std::invoke(function, *item) : otherwise;
    }
    /** In alphabetical order. */
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

/** What was unloaded and may still be executed: it has itself as long as that lasts. Thread safe. */
class Retired {
public:
    typedef boost::shared_ptr<base::ExecutableInterface> Pointer;

    void add(Pointer item) {
        const std::lock_guard<std::mutex> lock(mutex_);
        items_.push_back(std::move(item));
    }
    /** What does not have itself: nobody can tell when it is not executed any more. */
    void keep(Pointer item) {
        const std::lock_guard<std::mutex> lock(mutex_);
        kept_.push_back(std::move(item));
    }
    /** Destroys those that nobody else has. Also within a step: the engine does not look at what was taken from it. */
    void dropUnused() {
        // Destroyed without the lock, as that may unload others; and again, because those may have had others.
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

    const boost::weak_ptr<Service> component;  ///< has an owner as long as that is not under destruction
    detail::Registry<ProgramInterface> programs;
    detail::Registry<StateMachine> machines;  ///< the root machines, and those below them as "root.sub"
    detail::Definitions definitions;
    Property<unsigned int> stepBudget{
        "StepBudget", "How often loops of a program, function or state machine may go round in one step; 0: no limit",
        0u};

    boost::intrusive_ptr<internal::DataSource<unsigned int>> roundLimit() const {
        return stepBudget.getAssignableDataSource();
    }
    detail::Retired retired;
};

}  // namespace RTT::scripting

#endif
