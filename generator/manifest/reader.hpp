// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads a component manifest into a model.
#ifndef OROFORGE_GENERATOR_MANIFEST_READER_HPP
#define OROFORGE_GENERATOR_MANIFEST_READER_HPP

#include <optional>
#include <string>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::manifest {

/// Returns nothing if the file is not XML or its root is not <package>. After other errors (see the sink) the model
/// holds what could be read, so that more checks can run and report all errors at once.
std::optional<model::Package> readFile(const std::string& path, diag::Sink& sink);

/// `name` is shown as the file name in diagnostics.
std::optional<model::Package> readText(const std::string& text, const std::string& name, diag::Sink& sink);

}  // namespace oroforge::manifest

#endif
