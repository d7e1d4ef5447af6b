// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "PropertyLoader.hpp"

#include <cpf/property_file.hpp>

#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>

namespace RTT::marsh {

namespace {

/** Runs `action(sink)`, logs the errors, and logs `done` if it succeeds. */
template <class Action>
bool logged(const std::string& done, Action action) {
    diag::Sink sink;
    const bool good = action(sink);
    logDiagnostics(sink);
    if (good) log(Info) << done << endlog();
    return good;
}

std::string loaded(const std::string& service, const std::string& file) {
    return "properties of service '" + service + "' were read from '" + file + "'";
}

std::string saved(const std::string& file) { return "wrote " + file; }

}  // namespace

PropertyLoader::PropertyLoader(TaskContext* target) : PropertyLoader(target->provides().get()) {}

PropertyLoader::PropertyLoader(Service* target) : bag_(target->properties()), name_(target->getName()) {}

bool PropertyLoader::load(const std::string& file) const {
    return logged(loaded(name_, file),
                  [&](diag::Sink& sink) { return loadFromFile(*bag_, file, LoadMode::load, sink); });
}

bool PropertyLoader::configure(const std::string& file, bool strict) const {
    const LoadMode mode = strict ? LoadMode::strictRefresh : LoadMode::refresh;
    return logged(loaded(name_, file), [&](diag::Sink& sink) { return loadFromFile(*bag_, file, mode, sink); });
}

bool PropertyLoader::configure(const std::string& file, const std::string& name) const {
    return logged(loaded(name_, file), [&](diag::Sink& sink) { return loadOneFromFile(*bag_, file, name, sink); });
}

bool PropertyLoader::store(const std::string& file) const {
    return logged(saved(file), [&](diag::Sink& sink) { return saveToFile(*bag_, file, SaveMode::store, sink); });
}

bool PropertyLoader::save(const std::string& file, bool all) const {
    return logged(saved(file), [&](diag::Sink& sink) {
        return saveToFile(*bag_, file, all ? SaveMode::merge : SaveMode::update, sink);
    });
}

bool PropertyLoader::save(const std::string& file, const std::string& name) const {
    return logged(saved(file), [&](diag::Sink& sink) { return saveOneToFile(*bag_, file, name, sink); });
}

}  // namespace RTT::marsh
