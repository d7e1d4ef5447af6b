// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Definitions of the scripts of one component, for later scripts.
#ifndef ORO_SCRIPTING_DETAIL_DEFINITIONS_HPP
#define ORO_SCRIPTING_DETAIL_DEFINITIONS_HPP

#include <rtt/scripting/detail/compile/source_file.hpp>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace RTT::scripting::detail {

/** A type of state machines: its tree, and its file with name and variables. */
struct MachineType {
    std::shared_ptr<const ast::StateMachine> tree;
    SourceFilePtr file;
    std::string text;  ///< its source, which begins at `at`
    ast::Place at;
};
typedef std::map<std::string, std::shared_ptr<const MachineType>> MachineTypes;

/** Thread safe: readers get and keep a snapshot. */
class Definitions {
public:
    /** The functions of all scopes, callable by name within the component's engine. */
    std::shared_ptr<const Functions> functions() const { return read(functions_); }
    std::shared_ptr<const MachineTypes> machineTypes() const { return read(machine_types_); }
    // A later definition replaces an earlier one in code that is compiled from now on.
    void define(std::shared_ptr<const FunctionDefinition> function) {
        const std::string name = function->name;
        put(functions_, name, std::move(function));
    }
    void define(std::shared_ptr<const MachineType> type) {
        const std::string name = type->tree->type.text;
        put(machine_types_, name, std::move(type));
    }
    void clear() {
        const std::lock_guard<std::mutex> lock(mutex_);
        functions_ = std::make_shared<Shared<Functions>>();
        machine_types_ = std::make_shared<Shared<MachineTypes>>();
    }

private:
    template <class Map>
    struct Shared {
        Map map;
        std::atomic<int> readers{0};
    };
    template <class Map>
    std::shared_ptr<const Map> read(const std::shared_ptr<Shared<Map>>& shared) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        shared->readers.fetch_add(1, std::memory_order_relaxed);
        // release: pairs with the load in put(), which changes a map that has no readers.
        return {&shared->map, [held = shared](const Map*) { held->readers.fetch_sub(1, std::memory_order_release); }};
    }
    /** Copies the map only if it has readers, because otherwise each of thousands of functions would copy all before
        it. */
    template <class Map, class Value>
    void put(std::shared_ptr<Shared<Map>>& shared, const std::string& name, Value value) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (shared->readers.load(std::memory_order_acquire) != 0) {
            auto copy = std::make_shared<Shared<Map>>();
            copy->map = shared->map;
            shared = std::move(copy);
        }
        shared->map[name] = std::move(value);
    }

    mutable std::mutex mutex_;
    std::shared_ptr<Shared<Functions>> functions_ = std::make_shared<Shared<Functions>>();
    std::shared_ptr<Shared<MachineTypes>> machine_types_ = std::make_shared<Shared<MachineTypes>>();
};

}  // namespace RTT::scripting::detail

#endif
