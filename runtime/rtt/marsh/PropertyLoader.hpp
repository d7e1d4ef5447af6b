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
 * Moves the properties of a component or service between memory and property files. If a function returns false, no
 * value was changed and all errors are in the log, with their places in the file. Not real-time safe; the caller sees
 * to it that the component does not use its properties meanwhile.
 */
class RTT_API PropertyLoader {
public:
    explicit PropertyLoader(TaskContext* target);
    explicit PropertyLoader(Service* target);

    /** Takes over what the file has, creating properties where there is none of that name. */
    bool load(const std::string& file) const;
    /** Takes over what both have; with `strict` every property must be in the file. */
    bool configure(const std::string& file, bool strict = true) const;
    /** Takes over one property by its path. */
    bool configure(const std::string& file, const std::string& name) const;
    // A literal would rather become the bool than a string.
    bool configure(const std::string& file, const char* name) const { return configure(file, std::string(name)); }

    /** Makes the file anew from all properties. */
    bool store(const std::string& file) const;
    /** Changes what the file has; with `all` also adds what it lacks. A missing file is made. */
    bool save(const std::string& file, bool all) const;
    /** Changes or adds one property by its path. */
    bool save(const std::string& file, const std::string& name) const;
    bool save(const std::string& file, const char* name) const { return save(file, std::string(name)); }

private:
    PropertyBag* bag_;
    std::string name_;
};

}  // namespace marsh
}  // namespace RTT

#endif
