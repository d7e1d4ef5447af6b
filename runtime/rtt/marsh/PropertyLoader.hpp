// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_LOADER_HPP
#define ORO_PROPERTY_LOADER_HPP

#include <rtt/rtt-config.h>
#include <string>

namespace RTT {

class PropertyBag;
class Service;
class TaskContext;

namespace marsh {

/**
 * Moves the properties of a component or service between memory and property files. If a function returns false, it
 * changed no value and logged all errors with their places in the file. Not real-time safe. The caller must ensure that
 * the component does not use its properties meanwhile.
 */
class RTT_API PropertyLoader {
public:
    explicit PropertyLoader(TaskContext* target);
    explicit PropertyLoader(Service* target);

    /** Sets the properties that the file names, and creates those that do not exist. */
    bool load(const std::string& file) const;
    /** Sets the properties that the file names and that exist; with `strict` the file must have every property. */
    bool configure(const std::string& file, bool strict = true) const;
    /** Sets one property, given its path. */
    bool configure(const std::string& file, const std::string& name) const;
    // Without this overload, a literal would convert to the bool `strict`.
    bool configure(const std::string& file, const char* name) const { return configure(file, std::string(name)); }

    /** Writes the file anew from all properties. */
    bool store(const std::string& file) const;
    /** Updates the properties that the file has; with `all`, also adds the others. Creates a missing file. */
    bool save(const std::string& file, bool all) const;
    /** Updates or adds one property, given its path. */
    bool save(const std::string& file, const std::string& name) const;
    bool save(const std::string& file, const char* name) const { return save(file, std::string(name)); }

private:
    PropertyBag* bag_;
    std::string name_;
};

}  // namespace marsh
}  // namespace RTT

#endif
