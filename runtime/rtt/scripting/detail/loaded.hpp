// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a scripting service keeps: programs and state machines by name, and what scripts have defined.
#ifndef ORO_SCRIPTING_DETAIL_LOADED_HPP
#define ORO_SCRIPTING_DETAIL_LOADED_HPP

#include <rtt/Property.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/definitions.hpp>

#include <boost/shared_ptr.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace RTT {
namespace scripting {

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

/** What was unloaded and may still be executed. Thread safe. */
class Retired {
public:
    typedef boost::shared_ptr<base::ExecutableInterface> Pointer;

    /** `forGood`: nobody can tell when it is not executed any more. */
    void add(Pointer item, bool forGood) {
        const std::lock_guard<std::mutex> lock(mutex_);
        (forGood ? kept_ : items_).push_back(std::move(item));
    }
    /** Destroys those that nobody else has: what is executed has itself. */
    void dropUnused() {
        std::vector<Pointer> unused;  // destroyed without the lock, as that may unload others
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto used =
            std::partition(items_.begin(), items_.end(), [](const Pointer& item) { return item.use_count() > 1; });
        std::move(used, items_.end(), std::back_inserter(unused));
        items_.erase(used, items_.end());
    }

private:
    std::mutex mutex_;
    std::vector<Pointer> items_, kept_;
};

}  // namespace detail

struct ScriptingService::Loaded {
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

}  // namespace scripting
}  // namespace RTT

#endif
