// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Writes a model as a component manifest, which the reader reads.
#ifndef OROFORGE_GENERATOR_MANIFEST_WRITER_HPP
#define OROFORGE_GENERATOR_MANIFEST_WRITER_HPP

#include <string>

#include <model/package.hpp>

namespace oroforge::manifest {

/// Returns the same text for the same model. Reading it gives an equal model, apart from places; defaults are left out.
std::string write(const model::Package& package);

}  // namespace oroforge::manifest

#endif
